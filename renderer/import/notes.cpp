// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace obscura::renderer::import_detail {
namespace {

constexpr std::size_t kMostThings = 6;
constexpr std::size_t kMostNotes = 100;

}  // namespace

void Notes::add(const std::string& what, const std::string& thing) {
    auto note = std::find_if(notes_.begin(), notes_.end(),
                             [&](const Note& known) { return known.what == what; });
    if (note == notes_.end()) {
        if (notes_.size() == kMostNotes) {
            notes_.push_back({"more notes than these are left out", {}, 0});
        }
        if (notes_.size() > kMostNotes) return;
        notes_.push_back({what, {}, 0});
        note = notes_.end() - 1;
    }
    if (thing.empty()) return;
    if (std::find(note->things.begin(), note->things.end(), thing) != note->things.end()) return;
    ++note->count;
    if (note->things.size() < kMostThings) note->things.push_back(thing);
}

std::vector<std::string> Notes::lines() const {
    std::vector<std::string> lines;
    for (const Note& note : notes_) {
        std::string line = note.what;
        if (!note.things.empty()) line += fmt::format(": {}", fmt::join(note.things, ", "));
        if (note.count > note.things.size()) {
            line += fmt::format(" and {} more", note.count - note.things.size());
        }
        lines.push_back(line);
    }
    return lines;
}

}  // namespace obscura::renderer::import_detail
