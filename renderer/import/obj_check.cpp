// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/obj_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/import/import.h"
#include "renderer/import/json_cursor.h"
#include "renderer/import/obj_text.h"

namespace obscura::renderer::import_detail {
namespace {

using Triple = std::array<double, 3>;

/// One corner of a face: indices from 1, 0 where there is none.
struct Corner {
    std::size_t position = 0;
    std::size_t uv = 0;
    std::size_t normal = 0;
};

struct Face {
    std::size_t first = 0;  ///< of its corners
    std::size_t count = 0;
    std::size_t material = 0;  ///< into the file's names
    int line = 0;
};

class ObjChecker {
  public:
    ObjChecker(std::string_view text, const std::string& name, Notes& notes)
        : lines_(text),
          name_(name),
          file_(one_line(std::filesystem::path(name).filename().string())),
          notes_(notes) {}

    CheckedObj run();

  private:
    [[noreturn]] void fail(int line, const std::string& message) const {
        throw base::bad_input("{}:{}: {}", name_, line, message);
    }
    /// Notes the statement at hand.
    void note(const std::string& what) {
        notes_.add(what, fmt::format("{}:{} ({})", file_, line_.number, one_line(line_.text)));
    }
    void statement();
    void position();
    void texture_coordinate();
    void normal();
    void face();
    void use_material(const std::string& name);
    void library();
    void not_shown(const std::string& key);
    /// The numbers after the first word; false where one is none.
    [[nodiscard]] bool numbers(std::size_t most, std::vector<double>& values) const;
    [[nodiscard]] Corner corner(std::string_view word);
    /// An index from 1, counted from the end where it is negative; 0 where the word is none.
    [[nodiscard]] static std::size_t index(std::string_view word, std::size_t before);
    void resolve();
    void write_vertices();
    void write_faces();
    [[nodiscard]] std::size_t corners_with(const Face& face, std::size_t Corner::*index) const;
    void write_face(const Face& face, bool with_normals, bool with_uv);

    ObjLines lines_;
    const std::string& name_;
    std::string file_;
    Notes& notes_;
    ObjLine line_;
    std::vector<std::string_view> words_;  ///< of it
    std::vector<Triple> positions_;
    std::vector<Triple> colours_;  ///< empty, or one a position
    std::vector<bool> normal_is_sound_;
    std::size_t uvs_ = 0;
    std::string others_;  ///< lines vt and vn
    std::map<std::string, std::size_t> material_numbers_;
    std::vector<std::string> material_names_;
    std::size_t material_ = 0;
    std::vector<Face> faces_;
    std::vector<Corner> corners_;
    CheckedObj checked_;
};

bool ObjChecker::numbers(std::size_t most, std::vector<double>& values) const {
    values.clear();
    for (std::size_t i = 1; i < words_.size() && values.size() < most; ++i) {
        double value = 0.0;
        if (!parse_number(words_[i], value) || !(std::abs(value) <= 1e30)) return false;
        values.push_back(value);
    }
    return true;
}

void ObjChecker::position() {
    if (positions_.size() == ImportLimits::kVertices) {
        fail(line_.number, fmt::format("more than {} vertices, which is what a scene may have here",
                                       ImportLimits::kVertices));
    }
    std::vector<double> values;
    if (!numbers(3, values) || values.size() < 3) {
        const bool comma = line_.text.find(',') != std::string::npos;
        fail(line_.number,
             fmt::format("\"{}\": a position wants three finite numbers{}", one_line(line_.text),
                         comma ? ", with a point where there is a comma" : ""));
    }
    positions_.push_back({values[0], values[1], values[2]});
    const std::size_t words = words_.size();
    Triple colour{1.0, 1.0, 1.0};
    if (words >= 7) {
        if (words > 7) note("numbers behind the colour of a vertex are left out");
        if (numbers(6, values)) {
            for (std::size_t i = 0; i < 3; ++i) colour[i] = values[3 + i];
            const auto [low, high] = std::minmax({colour[0], colour[1], colour[2]});
            if (low < 0.0 || high > 1.0) note("colours of vertices are limited to 0 to 1");
        } else {
            note("a vertex's colour wants three finite numbers; white stands in");
        }
        if (colours_.empty()) colours_.assign(positions_.size() - 1, Triple{1.0, 1.0, 1.0});
        if (colours_.size() < positions_.size()) colours_.push_back(colour);
        return;
    }
    // The weight of rational curves: nothing to a polygon.
    if (words == 6 || (words == 5 && (!numbers(4, values) || values[3] != 1.0))) {
        note("numbers behind the position of a vertex that are no colour are left out");
    }
    if (!colours_.empty()) colours_.push_back(colour);
}

void ObjChecker::texture_coordinate() {
    std::vector<double> values;
    const bool sound = numbers(2, values) && !values.empty();
    if (!sound) {
        note("vt wants one to three finite numbers; 0 0 stands in");
        values = {0.0, 0.0};
    }
    if (values.size() == 1) values.push_back(0.0);
    fmt::format_to(std::back_inserter(others_), "vt {} {}\n", values[0], values[1]);
    ++uvs_;
}

void ObjChecker::normal() {
    std::vector<double> values;
    bool sound = numbers(3, values) && values.size() == 3;
    if (!sound) values = {0.0, 0.0, 1.0};
    const double length = std::hypot(values[0], values[1], values[2]);
    if (sound && !(length > 1e-6)) sound = false;
    if (sound && (length < 0.5 || length > 2.0)) {
        for (double& value : values) value /= length;
    }
    if (!sound) note("vn wants three finite numbers that are a direction; normals are made anew");
    normal_is_sound_.push_back(sound);
    fmt::format_to(std::back_inserter(others_), "vn {} {} {}\n", values[0], values[1], values[2]);
}

std::size_t ObjChecker::index(std::string_view word, std::size_t before) {
    std::int64_t value = 0;
    if (word.starts_with('+')) word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || rest != end || word.empty()) return 0;
    const auto most = static_cast<std::int64_t>(before);
    if (value < -most) return 0;
    return static_cast<std::size_t>(value >= 0 ? value : most + value + 1);
}

Corner ObjChecker::corner(std::string_view word) {
    Corner result;
    const std::size_t first = std::min(word.find('/'), word.size());
    const std::string_view position = word.substr(0, first);
    result.position = index(position, positions_.size());
    if (result.position == 0) {
        const std::size_t before = positions_.size();
        fail(line_.number,
             fmt::format("\"{}\" is no index of a vertex; {}", one_line(position),
                         before == 0 ? "wanted is a number from 1 on"
                                     : fmt::format("wanted is a number from 1 on, or from -1 to "
                                                   "-{}, counted back from this line",
                                                   before)));
    }
    if (first == word.size()) return result;
    const std::size_t second = std::min(word.find('/', first + 1), word.size());
    const std::string_view uv = word.substr(first + 1, second - first - 1);
    if (!uv.empty()) {
        result.uv = index(uv, uvs_);
        if (result.uv == 0) note("a corner's vt wants the index of one; it has none");
    }
    if (second == word.size()) return result;
    const std::string_view normal = word.substr(second + 1);
    if (!normal.empty()) {
        result.normal = index(normal, normal_is_sound_.size());
        if (result.normal == 0) note("a corner's vn wants the index of one; normals are made anew");
    }
    return result;
}

void ObjChecker::face() {
    constexpr std::size_t kMostCorners = 1024;
    if (words_.size() < 4 || words_.size() > kMostCorners + 1) {
        fail(line_.number, fmt::format("a face of {} corners, allowed are 3 to {}",
                                       words_.size() - 1, kMostCorners));
    }
    checked_.triangles += words_.size() - 3;
    if (checked_.triangles > kMostObjTriangles) {
        fail(line_.number,
             fmt::format("more than {} triangles, which is what an OBJ file may have here; convert "
                         "it to .glb",
                         kMostObjTriangles));
    }
    faces_.push_back({corners_.size(), words_.size() - 1, material_, line_.number});
    for (std::size_t i = 1; i < words_.size(); ++i) corners_.push_back(corner(words_[i]));
}

void ObjChecker::use_material(const std::string& name) {
    const auto known = material_numbers_.find(name);
    material_ = 0;
    if (known != material_numbers_.end()) {
        material_ = known->second;
    } else if (material_names_.size() > ImportLimits::kMaterials) {
        note(fmt::format("a scene may have {} materials; others are none",
                         ImportLimits::kMaterials));
    } else {
        material_ = material_names_.size();
        material_numbers_.emplace(name, material_);
        material_names_.push_back(name);
    }
}

void ObjChecker::not_shown(const std::string& key) {
    using Words = std::set<std::string, std::less<>>;
    static const Words kCurves = {
        "vp",   "cstype", "deg", "bmat", "step",  "curv", "curv2", "surf", "parm", "trim", "hole",
        "scrv", "sp",     "end", "con",  "ctech", "res",  "stech", "bsp",  "bzp",  "cdc",  "cdp"};
    // Groups, smoothing, and what only says how lines, curves and distant things are drawn.
    static const Words kOfNoEffect = {"g",     "o",        "s",        "mg",         "lod",
                                      "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
    if (kOfNoEffect.contains(key)) return;
    if (kCurves.contains(key)) {
        note("curves and surfaces are left out; polygons of them would be shown");
    } else if (key == "l" || key == "p") {
        note("lines and points are left out");
    } else if (key == "call" || key == "csh") {
        note("files and commands that call and csh name are left out, with their geometry");
    } else if (key == "maplib" || key == "usemap") {
        note("textures of maplib and usemap are left out");
    } else {
        note("statements that are not known are passed over");
    }
}

void ObjChecker::library() {
    constexpr std::size_t kMost = 256;
    std::vector<std::string>& all = checked_.libraries;
    const std::string names(line_.rest());
    if (names.empty() || std::find(all.begin(), all.end(), names) != all.end()) return;
    if (all.size() == kMost) return note(fmt::format("of mtllib statements {} are read", kMost));
    all.push_back(names);
}

void ObjChecker::statement() {
    const std::string key = line_.key();
    if (key == "v") {
        position();
    } else if (key == "vt") {
        texture_coordinate();
    } else if (key == "vn") {
        normal();
    } else if (key == "f" || key == "fo") {
        face();
    } else if (key == "usemtl") {
        use_material(std::string(line_.rest()));
    } else if (key == "mtllib") {
        library();
    } else {
        not_shown(key);
    }
}

/// Holds the corners against what the whole file has: a face may stand before its vertices.
void ObjChecker::resolve() {
    for (const Face& face : faces_) {
        bool uv_is_missing = false;
        bool normal_is_missing = false;
        for (std::size_t i = face.first; i < face.first + face.count; ++i) {
            Corner& c = corners_[i];
            if (c.position > positions_.size()) {
                fail(face.line, fmt::format("\"{}\" is no index of a vertex; the file has {}",
                                            c.position, positions_.size()));
            }
            if (c.uv > uvs_) {
                uv_is_missing = true;
                c.uv = 0;
            }
            if (c.normal > normal_is_sound_.size()) {
                normal_is_missing = true;
                c.normal = 0;
            }
            if (c.normal != 0 && !normal_is_sound_[c.normal - 1]) c.normal = 0;
        }
        const auto note = [&](const char* what, std::size_t count, const char* instead) {
            notes_.add(fmt::format("corners name a {} that is not there (the file has {}): {}",
                                   what, count, instead),
                       fmt::format("{}:{}", file_, face.line));
        };
        if (uv_is_missing) note("vt", uvs_, "they have none");
        if (normal_is_missing) note("vn", normal_is_sound_.size(), "normals are made anew");
    }
}

void ObjChecker::write_face(const Face& face, bool with_normals, bool with_uv) {
    checked_.text += 'f';
    auto out = std::back_inserter(checked_.text);
    for (std::size_t i = face.first; i < face.first + face.count; ++i) {
        const Corner& c = corners_[i];
        fmt::format_to(out, " {}", c.position);
        if (with_uv) fmt::format_to(out, "/{}", c.uv != 0 ? c.uv : uvs_);
        if (with_normals) fmt::format_to(out, "{}{}", with_uv ? "/" : "//", c.normal);
    }
    checked_.text += '\n';
}

void ObjChecker::write_vertices() {
    auto out = std::back_inserter(checked_.text);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        const Triple& p = positions_[i];
        fmt::format_to(out, "v {} {} {}", p[0], p[1], p[2]);
        if (!colours_.empty()) {
            fmt::format_to(out, " {} {} {}", colours_[i][0], colours_[i][1], colours_[i][2]);
        }
        checked_.text += '\n';
    }
    positions_.clear();
    checked_.text += std::exchange(others_, {});
}

/// How many corners of a face have what `index` counts.
std::size_t ObjChecker::corners_with(const Face& face, std::size_t Corner::*index) const {
    std::size_t count = 0;
    for (std::size_t i = face.first; i < face.first + face.count; ++i) {
        count += corners_[i].*index != 0 ? 1U : 0U;
    }
    return count;
}

/// The faces of one material together, those with normals apart from those without.
void ObjChecker::write_faces() {
    std::map<std::pair<std::size_t, bool>, std::size_t> numbers;
    std::vector<std::vector<std::size_t>> faces_of;
    bool zero_is_there = false;
    checked_.faces = faces_.size();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        const Face& face = faces_[f];
        const bool with_normals = corners_with(face, &Corner::normal) == face.count;
        if (!with_normals) ++checked_.faces_without_normals;
        const auto [number, fresh] =
            numbers.try_emplace({face.material, with_normals}, faces_of.size());
        if (fresh) {
            faces_of.emplace_back();
            checked_.materials.push_back(material_names_[face.material]);
        }
        faces_of[number->second].push_back(f);
        const std::size_t with_uv = corners_with(face, &Corner::uv);
        if (with_uv == 0 || with_uv == face.count) continue;
        notes_.add("faces of which some corners have a vt get 0 0 at the others",
                   fmt::format("{}:{}", file_, face.line));
        if (!std::exchange(zero_is_there, true)) {
            checked_.text += "vt 0 0\n";
            ++uvs_;
        }
    }
    for (std::size_t m = 0; m < faces_of.size(); ++m) {
        checked_.text += fmt::format("usemtl m{}\n", m);
        for (const std::size_t f : faces_of[m]) {
            const Face& face = faces_[f];
            write_face(face, corners_with(face, &Corner::normal) == face.count,
                       corners_with(face, &Corner::uv) > 0);
        }
    }
}

CheckedObj ObjChecker::run() {
    use_material("");
    while (lines_.next(line_)) {
        words_ = line_.words();
        statement();
    }
    if (corners_.empty()) throw base::bad_input("{}: it holds no faces", name_);
    resolve();
    write_vertices();
    write_faces();
    return std::move(checked_);
}

}  // namespace

CheckedObj check_obj(std::string_view text, const std::string& name, Notes& notes) {
    return ObjChecker(text, name, notes).run();
}

}  // namespace obscura::renderer::import_detail
