// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "renderer/import/json_cursor.h"
#include "renderer/import/mtl_text.h"

namespace obscura::renderer::import_detail {
namespace {

/// What follows an option of a map (Wavefront, MTL material format 4.2, "Options for texture map
/// statements").
enum class Wants { kSwitch, kNumbers, kChannel, kShape };

struct Option {
    std::string_view name;
    Wants wants = Wants::kSwitch;
    std::size_t least = 1;  ///< numbers
    std::size_t most = 1;
    /// The value of which nothing is to be done, for a switch or each number; empty: there is none.
    std::string_view idle = {};
};

constexpr std::array<Option, 13> kOptions = {{{"-blendu", Wants::kSwitch, 1, 1, "on"},
                                              {"-blendv", Wants::kSwitch, 1, 1, "on"},
                                              {"-cc", Wants::kSwitch, 1, 1, "off"},
                                              {"-clamp", Wants::kSwitch, 1, 1, "off"},
                                              {"-bm", Wants::kNumbers, 1, 1, ""},
                                              {"-boost", Wants::kNumbers, 1, 1, ""},
                                              {"-texres", Wants::kNumbers, 1, 1, ""},
                                              {"-mm", Wants::kNumbers, 2, 2, "01"},
                                              {"-o", Wants::kNumbers, 1, 3, "000"},
                                              {"-s", Wants::kNumbers, 1, 3, "111"},
                                              {"-t", Wants::kNumbers, 1, 3, "000"},
                                              {"-imfchan", Wants::kChannel, 1, 1, ""},
                                              {"-type", Wants::kShape, 1, 1, ""}}};

std::string_view word_of(std::string_view text) {
    return text.substr(0, text.find_first_of(" \t\r\v\f"));
}

class MapReader {
  public:
    MapReader(const ObjLine& line, const std::string& place, bool scalar, Notes& notes)
        : left_(line.rest()), scalar_(scalar), notes_(notes) {
        map_.place = place;
    }

    MtlMap run() {
        // The last word is the file's name, whatever it looks like.
        while (left_.starts_with('-') && word_of(left_).size() < left_.size()) option();
        name_file();
        return std::move(map_);
    }

  private:
    [[nodiscard]] bool has_next() const { return word_of(left_).size() < left_.size(); }
    void drop() { left_ = trimmed(left_.substr(word_of(left_).size())); }
    void note(const std::string& what) { notes_.add(what, map_.place); }
    void option();
    void numbers(const Option& option);
    void unknown(const std::string& name);
    void name_file();

    std::string_view left_;
    bool scalar_;
    Notes& notes_;
    MtlMap map_;
};

void MapReader::option() {
    const std::string name = lower(word_of(left_));
    drop();
    const auto* const option = std::find_if(kOptions.begin(), kOptions.end(),
                                            [&](const Option& one) { return one.name == name; });
    if (option == kOptions.end()) return unknown(name);
    if (option->wants == Wants::kNumbers) return numbers(*option);
    const std::string value = lower(word_of(left_));
    constexpr std::string_view kChannels = "rgbmlz";
    const bool sound =
        has_next() && (option->wants == Wants::kSwitch ? value == "on" || value == "off"
                       : option->wants == Wants::kChannel
                           ? value.size() == 1 && kChannels.find(value) != std::string_view::npos
                           : value == "sphere" || value.starts_with("cube_"));
    if (!sound) {
        return note(fmt::format("the texture option {} wants {}", name,
                                option->wants == Wants::kSwitch    ? "on or off"
                                : option->wants == Wants::kChannel ? "r, g, b, m, l or z"
                                                                   : "sphere or cube_ and a side"));
    }
    drop();
    if (option->wants == Wants::kChannel && scalar_ && value != "z") {
        map_.channel = static_cast<ImageChannel>(kChannels.find(value));
    } else if (value != option->idle) {
        note(fmt::format("the texture option {} {} is not obeyed", name, value));
    }
}

void MapReader::numbers(const Option& option) {
    std::size_t count = 0;
    double value = 0.0;
    bool idle = !option.idle.empty();
    while (count < option.most && has_next() && parse_number(word_of(left_), value)) {
        idle = idle && value == option.idle[count] - '0';
        ++count;
        drop();
    }
    if (count < option.least) {
        note(fmt::format("the texture option {} wants {} number{}", option.name, option.least,
                         option.least == 1 ? "" : "s"));
    } else if (option.name == "-bm" && scalar_) {
        map_.strength = value;
    } else if (!idle) {
        note(fmt::format("the texture option {} is not obeyed", option.name));
    }
}

void MapReader::unknown(const std::string& name) {
    double value = 0.0;
    while (has_next() && (parse_number(word_of(left_), value) || lower(word_of(left_)) == "on" ||
                          lower(word_of(left_)) == "off")) {
        drop();
    }
    note(fmt::format("the texture option {} is not known", one_line(name)));
}

/// A name may hold blanks, quotes and '#', so that only the disk can tell where it ends: all of it,
/// then without a comment, then without options that follow it.
void MapReader::name_file() {
    std::vector<std::string_view> ends = {left_, without_comment(left_)};
    for (std::size_t at = left_.find(" -"); at != std::string_view::npos;
         at = left_.find(" -", at + 1)) {
        const std::string word = lower(word_of(left_.substr(at + 1)));
        if (std::any_of(kOptions.begin(), kOptions.end(),
                        [&](const Option& one) { return one.name == word; })) {
            ends.push_back(trimmed(left_.substr(0, at)));
            break;
        }
    }
    for (const std::string_view end : ends) {
        for (const std::string_view name : {end, without_quotes(end)}) {
            const bool fresh =
                std::find(map_.names.begin(), map_.names.end(), name) == map_.names.end();
            if (fresh && !name.empty()) map_.names.emplace_back(name);
        }
    }
}

}  // namespace

MtlMap read_map(const ObjLine& line, const std::string& place, bool scalar, Notes& notes) {
    return MapReader(line, place, scalar, notes).run();
}

}  // namespace obscura::renderer::import_detail
