// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/obj_check.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>

#include "renderer/base/error.h"
#include "renderer/import/json_cursor.h"

namespace obscura::renderer::import_detail {
namespace {

/// One corner of a face: indices from 1, 0 where there is none.
struct Corner {
    std::size_t position = 0;
    std::size_t uv = 0;
    std::size_t normal = 0;
};

class ObjChecker {
  public:
    ObjChecker(std::string_view text, const std::string& name, Notes& notes)
        : rest_(text), name_(name), notes_(notes) {}

    CheckedObj run();

  private:
    [[noreturn]] void fail(const std::string& message) const {
        throw base::bad_input("{}:{}: {}", name_, line_, message);
    }
    void statement(const std::vector<std::string_view>& words, std::string_view line);
    void vector(const std::vector<std::string_view>& words, std::size_t least, std::size_t most,
                std::size_t keep);
    void face(const std::vector<std::string_view>& words);
    void use_material(const std::string& name);
    [[nodiscard]] Corner corner(std::string_view word) const;
    [[nodiscard]] std::size_t index(std::string_view word, std::size_t count,
                                    const char* what) const;
    void write();

    std::string_view rest_;
    const std::string& name_;
    Notes& notes_;
    int line_ = 0;
    std::vector<std::string> positions_;  ///< as words: "x y z"
    std::vector<std::string> colours_;    ///< "r g b", empty where a vertex has none
    std::size_t uvs_ = 0;
    std::size_t normals_ = 0;
    bool all_normals_ = true;
    std::map<std::string, std::size_t> material_numbers_;
    std::string other_;  ///< lines vt and vn
    /// Faces and the lines between them, in order.
    struct Part {
        std::string line;  ///< the material from here on; empty: a face
        std::size_t first = 0;
        std::size_t count = 0;
    };
    std::vector<Part> parts_;
    std::vector<Corner> corners_;
    CheckedObj checked_;
};

void ObjChecker::vector(const std::vector<std::string_view>& words, std::size_t least,
                        std::size_t most, std::size_t keep) {
    if (words.size() - 1 < least) {
        fail(fmt::format("{} has {} numbers, allowed are {} to {}", words[0], words.size() - 1,
                         least, most));
    }
    std::string kept;
    for (std::size_t i = 1; i < words.size() && i <= most; ++i) {
        double value = 0.0;
        if (!parse_number(words[i], value) || !(std::abs(value) <= 1e30)) {
            fail(fmt::format("\"{}\" is no number that is allowed here, which are finite ones",
                             one_line(words[i])));
        }
        if (i <= keep) kept += fmt::format("{}{}", i == 1 ? "" : " ", value);
    }
    if (words[0] == "v") {
        positions_.push_back(kept);
        const bool coloured = words.size() - 1 >= 6;
        colours_.push_back(coloured ? fmt::format("{} {} {}", words[4], words[5], words[6]) : "");
    } else {
        fmt::format_to(std::back_inserter(other_), "{} {}\n", words[0], kept);
    }
}

std::size_t ObjChecker::index(std::string_view word, std::size_t count, const char* what) const {
    std::int64_t value = 0;
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, value);
    const auto most = static_cast<std::int64_t>(count);
    if (error != std::errc() || rest != end || value == 0 || value > most || value < -most) {
        fail(
            fmt::format("\"{}\" is no index of a {}; there are {} before this line, allowed are 1 "
                        "to {} and -1 to -{}",
                        one_line(word), what, count, count, count));
    }
    return static_cast<std::size_t>(value > 0 ? value : most + value + 1);
}

Corner ObjChecker::corner(std::string_view word) const {
    Corner result;
    const std::size_t first = word.find('/');
    result.position = index(word.substr(0, first), positions_.size(), "vertex");
    if (first == std::string_view::npos) return result;
    const std::size_t second = word.find('/', first + 1);
    const std::string_view uv =
        word.substr(first + 1, second == std::string_view::npos ? second : second - first - 1);
    if (!uv.empty()) result.uv = index(uv, uvs_, "texture coordinate");
    if (second == std::string_view::npos) return result;
    const std::string_view normal = word.substr(second + 1);
    if (!normal.empty()) result.normal = index(normal, normals_, "normal");
    return result;
}

void ObjChecker::face(const std::vector<std::string_view>& words) {
    constexpr std::size_t kMostCorners = 1024;
    if (words.size() < 4 || words.size() > kMostCorners + 1) {
        fail(fmt::format("a face of {} corners, allowed are 3 to {}", words.size() - 1,
                         kMostCorners));
    }
    checked_.triangles += words.size() - 3;
    if (checked_.triangles > kMostObjTriangles) {
        fail(
            fmt::format("more than {} triangles, which is what an OBJ file may have here; convert "
                        "it to .glb",
                        kMostObjTriangles));
    }
    parts_.push_back({"", corners_.size(), words.size() - 1});
    bool uniform_uv = true;
    for (std::size_t i = 1; i < words.size(); ++i) {
        corners_.push_back(corner(words[i]));
        all_normals_ = all_normals_ && corners_.back().normal != 0;
        uniform_uv =
            uniform_uv && (corners_.back().uv != 0) == (corners_[parts_.back().first].uv != 0);
    }
    if (!uniform_uv) fail("some corners have texture coordinates and others none");
}

void ObjChecker::statement(const std::vector<std::string_view>& words, std::string_view line) {
    const std::string_view key = words[0];
    const auto rest_of_line = [&] {
        const auto from = static_cast<std::size_t>(words[1].data() - line.data());
        return std::string(line.substr(from, line.find_last_not_of(" \t\r") + 1 - from));
    };
    if (key == "v") {
        vector(words, 3, 7, 3);
    } else if (key == "vt") {
        vector(words, 1, 3, 2);
        if (words.size() == 2) other_.insert(other_.size() - 1, " 0");
        ++uvs_;
    } else if (key == "vn") {
        vector(words, 3, 3, 3);
        ++normals_;
    } else if (key == "f") {
        face(words);
    } else if (key == "usemtl") {
        use_material(words.size() > 1 ? rest_of_line() : "");
    } else if (key == "mtllib") {
        if (words.size() > 1) checked_.libraries.push_back(rest_of_line());
    } else if (key != "g" && key != "o" && key != "s") {
        notes_.add("statements that are not shown", one_line(key));
    }
}

/// Names may hold blanks and more; the library gets plain ones.
void ObjChecker::use_material(const std::string& name) {
    std::vector<std::string>& names = checked_.materials;
    const auto found = material_numbers_.try_emplace(name, names.size());
    if (found.second) names.push_back(name);
    parts_.push_back({fmt::format("m{}", found.first->second), 0, 0});
}

void ObjChecker::write() {
    bool all_coloured = true;
    for (const std::string& colour : colours_) all_coloured = all_coloured && !colour.empty();
    auto out = std::back_inserter(checked_.text);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        fmt::format_to(out, "v {}{}{}\n", positions_[i], all_coloured ? " " : "",
                       all_coloured ? colours_[i] : "");
    }
    positions_.clear();
    checked_.text += other_;
    checked_.has_normals = all_normals_ && normals_ > 0;
    for (const Part& part : parts_) {
        if (part.count == 0) {
            fmt::format_to(out, "usemtl {}\n", part.line);
            continue;
        }
        checked_.text += 'f';
        for (std::size_t i = part.first; i < part.first + part.count; ++i) {
            const Corner& c = corners_[i];
            const std::string uv = c.uv != 0 ? fmt::format("{}", c.uv) : "";
            if (checked_.has_normals) {
                fmt::format_to(out, " {}/{}/{}", c.position, uv, c.normal);
            } else {
                fmt::format_to(out, " {}{}{}", c.position, uv.empty() ? "" : "/", uv);
            }
        }
        checked_.text += '\n';
    }
}

CheckedObj ObjChecker::run() {
    while (!rest_.empty()) {
        const std::string line = next_line(rest_, line_);
        const auto words = words_of(line);
        if (!words.empty()) statement(words, line);
    }
    if (corners_.empty()) throw base::bad_input("{}: it holds no faces", name_);
    if (normals_ > 0 && !all_normals_) {
        notes_.add("some faces have normals and others none: all are made anew");
    }
    write();
    return std::move(checked_);
}

}  // namespace

std::vector<std::string_view> words_of(std::string_view line) {
    line = line.substr(0, line.find('#'));
    std::vector<std::string_view> words;
    for (;;) {
        const std::size_t from = line.find_first_not_of(" \t\r");
        if (from == std::string_view::npos) return words;
        line.remove_prefix(from);
        const std::size_t length = std::min(line.find_first_of(" \t\r"), line.size());
        words.push_back(line.substr(0, length));
        line.remove_prefix(length);
    }
}

std::string next_line(std::string_view& rest, int& number) {
    std::string line;
    for (;;) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        line += rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        ++number;
        if (line.ends_with('\r')) line.pop_back();
        if (!line.ends_with('\\') || rest.empty()) return line;
        line.back() = ' ';
    }
}

bool parse_number(std::string_view word, double& value) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, value);
    return error == std::errc() && rest == end && std::isfinite(value);
}

CheckedObj check_obj(std::string_view text, const std::string& name, Notes& notes) {
    return ObjChecker(text, name, notes).run();
}

}  // namespace obscura::renderer::import_detail
