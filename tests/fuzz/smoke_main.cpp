// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Feeds a fuzz target without a fuzzer: every file of a corpus whole, cut short, and with bytes
// changed by a seeded generator, so that the same bytes are read each time. A target that finds
// something wrong ends the program. Usage: smoke CORPUS_FOLDER CHANGES_A_FILE
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kCuts = 64;
constexpr std::uint32_t kSeed = 20100501;

Bytes read(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void feed(const Bytes& bytes) { LLVMFuzzerTestOneInput(bytes.data(), bytes.size()); }

/// Up to eight bytes overwritten, dropped or doubled.
Bytes changed(Bytes bytes, std::mt19937& random) {
    const std::uint32_t changes = 1 + random() % 8;
    for (std::uint32_t i = 0; i < changes && !bytes.empty(); ++i) {
        const auto at = static_cast<std::ptrdiff_t>(random() % bytes.size());
        switch (random() % 4) {
            case 0:
                bytes.erase(bytes.begin() + at);
                break;
            case 1:
                bytes.insert(bytes.begin() + at, bytes[static_cast<std::size_t>(at)]);
                break;
            default:
                bytes[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(random());
        }
    }
    return bytes;
}

}  // namespace

int main(int count, char** words) {
    const int changes = count == 3 ? std::atoi(words[2]) : 0;
    if (changes <= 0) {
        std::fprintf(stderr, "usage: %s CORPUS_FOLDER CHANGES_A_FILE\n", words[0]);
        return 2;
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(words[1])) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::mt19937 random(kSeed);
    feed({});
    for (const std::filesystem::path& file : files) {
        const Bytes whole = read(file);
        feed(whole);
        for (std::size_t cut = 0; cut < kCuts; ++cut) {
            feed({whole.begin(),
                  whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * cut / kCuts)});
        }
        for (int i = 0; i < changes; ++i) feed(changed(whole, random));
    }
    std::printf("%zu files, each whole, cut %zu times and changed %d times\n", files.size(), kCuts,
                changes);
    return files.empty() ? 1 : 0;
}
