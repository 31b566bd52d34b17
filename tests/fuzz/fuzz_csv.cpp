// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Any bytes as a file of counts and as one of trials: read, or refused as bad input with the place.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "analysis/counts_file.h"
#include "analysis/text/text.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

constexpr const char* kName = "f.csv";

void require(bool holds, const char* what, const std::string& met) {
    if (holds) return;
    std::fprintf(stderr, "%s: %s\n", what, met.c_str());
    std::abort();
}

/// Every line of the message is `f.csv:LINE: ...`, but for a file in which nothing stands, and no
/// control character of the file is in it.
void check_refusal(const base::Error& error) {
    const std::string message = error.what();
    require(error.code() == base::ExitCode::kBadInput, "refused, but not as bad input", message);
    require(is_utf8(message), "the refusal is not UTF-8", "");
    const bool blank = message.find("the file is empty") != std::string::npos;
    const std::string place = std::string(kName) + ':';
    require(message.starts_with(place), "the refusal names no file", message);
    const char next = message.size() > place.size() ? message[place.size()] : ' ';
    require(blank || (next >= '1' && next <= '9'), "the refusal names no line", message);
    for (const char letter : message) {
        require(letter == '\n' || (letter >= ' ' || letter < 0), "a control character", message);
    }
}

void check_votes(const Tally& tally) {
    for (const ConditionVotes& condition : tally.conditions) {
        require(condition.votes.a >= 0 && condition.votes.b >= 0, "negative votes", condition.id);
        const auto answers = static_cast<std::int64_t>(condition.answers.size());
        require(answers == 0 || answers == condition.votes.n(), "votes without an answer",
                condition.id);
    }
}

void fuzz_counts(std::string_view text) {
    try {
        check_votes(parse_counts(std::string(text), kName));
    } catch (const base::Error& error) {
        check_refusal(error);
    }
}

void fuzz_trials(std::string_view text) {
    try {
        const auto trials = parse_trials(std::string(text), kName);
        for (const Kind kind : {Kind::kParticipant, Kind::kSimulated}) {
            try {
                check_votes(tally_of(trials, "", kind));
            } catch (const base::Error& error) {  // none of that kind, or of several studies
                require(error.code() == base::ExitCode::kBadInput, "not bad input", error.what());
            }
        }
    } catch (const base::Error& error) {
        check_refusal(error);
    }
}

}  // namespace
}  // namespace obscura::analysis

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    obscura::analysis::fuzz_counts(text);
    obscura::analysis::fuzz_trials(text);
    return 0;
}
