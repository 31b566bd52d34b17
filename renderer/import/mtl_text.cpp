// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/mtl_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "renderer/import/import.h"
#include "renderer/import/json_cursor.h"

namespace obscura::renderer::import_detail {
namespace {

class MtlText {
  public:
    MtlText(std::string_view text, const std::string& file, Notes& notes)
        : lines_(text), file_(one_line(file)), notes_(notes) {}

    std::vector<MtlMaterial> run() {
        while (lines_.next(line_)) {
            const std::string key = line_.key();
            if (key == "newmtl" && materials_.size() == ImportLimits::kMaterials) {
                note(fmt::format("a scene may have {} materials; others are left out",
                                 ImportLimits::kMaterials));
                break;
            }
            if (key == "newmtl") {
                materials_.emplace_back().name = line_.rest();
            } else if (materials_.empty()) {
                note("statements before the first newmtl are left out");
            } else {
                statement(key, materials_.back());
            }
        }
        return std::move(materials_);
    }

  private:
    [[nodiscard]] std::string place() const { return fmt::format("{}:{}", file_, line_.number); }
    void note(const std::string& what) {
        notes_.add(what, fmt::format("{} ({})", place(), one_line(line_.text)));
    }
    void statement(const std::string& key, MtlMaterial& material);
    [[nodiscard]] bool map(const std::string& key, MtlMaterial& material);
    void colour(std::optional<glm::vec3>& value);
    void number(std::optional<double>& value);
    void share(std::optional<double>& value);
    void illumination(MtlMaterial& material);

    ObjLines lines_;
    std::string file_;
    Notes& notes_;
    ObjLine line_;
    std::vector<MtlMaterial> materials_;
};

/// One number stands for three.
void MtlText::colour(std::optional<glm::vec3>& value) {
    const auto words = line_.words();
    glm::dvec3 c(0.0);
    bool sound = words.size() == 2 || words.size() >= 4;
    for (int i = 0; sound && i < 3; ++i) {
        const std::size_t word = words.size() == 2 ? 1 : static_cast<std::size_t>(i) + 1;
        sound = parse_number(words[word], c[i]) && c[i] >= 0.0 && c[i] <= 1e6;
    }
    if (!sound) {
        note(fmt::format("{} wants one or three numbers from 0 on; it is passed over", words[0]));
        return;
    }
    if (words.size() > 4) note("numbers behind the third of a colour are left out");
    value = glm::vec3(c);
}

void MtlText::number(std::optional<double>& value) {
    const auto words = line_.words();
    double n = 0.0;
    if (words.size() < 2 || !parse_number(words[1], n) || n < 0.0) {
        note(fmt::format("{} wants a number from 0 on; it is passed over", words[0]));
        return;
    }
    value = n;
}

void MtlText::share(std::optional<double>& value) {
    auto words = line_.words();
    if (words.size() > 1 && lower(words[1]) == "-halo") {
        note("-halo is not obeyed: the opacity is the same from every side");
        words.erase(words.begin() + 1);
    }
    double n = 0.0;
    if (words.size() < 2 || !parse_number(words[1], n)) {
        note(fmt::format("{} wants a number from 0 to 1; it is passed over", words[0]));
        return;
    }
    if (n < 0.0 || n > 1.0) note(fmt::format("{} is limited to 0 to 1", words[0]));
    value = std::clamp(n, 0.0, 1.0);
}

void MtlText::illumination(MtlMaterial& material) {
    const auto words = line_.words();
    double model = 0.0;
    if (words.size() < 2 || !parse_number(words[1], model) || model < 0.0 || model > 10.0) {
        note("illum wants a number from 0 to 10; it is passed over");
        return;
    }
    material.illum = static_cast<int>(model);
}

bool MtlText::map(const std::string& key, MtlMaterial& material) {
    std::optional<MtlMap>* const kept = key == "map_kd"                      ? &material.map_kd
                                        : key == "map_ke"                    ? &material.map_ke
                                        : key == "map_d"                     ? &material.map_d
                                        : key == "bump" || key == "map_bump" ? &material.bump
                                        : key == "norm"                      ? &material.norm
                                                                             : nullptr;
    if (kept == nullptr) {
        if (!key.starts_with("map_") && key != "disp" && key != "decal" && key != "refl") {
            return false;
        }
        // Most often map_Ka is what map_Kd is.
        if (key == "map_ka") material.map_ka = place();
        if (key != "map_ka") note(fmt::format("maps that are left out: {}", key));
        return true;
    }
    const bool scalar = key == "map_d" || key == "bump" || key == "map_bump";
    MtlMap read = read_map(line_, place(), scalar, notes_);
    if (read.names.empty()) {
        note("maps without a file are left out");
    } else {
        *kept = std::move(read);
    }
    return true;
}

void MtlText::statement(const std::string& key, MtlMaterial& material) {
    static const std::set<std::string, std::less<>> kOfNoEffect = {"ka", "ni", "sharpness"};
    if (key == "kd") {
        colour(material.kd);
    } else if (key == "ks") {
        colour(material.ks);
    } else if (key == "ke") {
        colour(material.ke);
    } else if (key == "ns") {
        number(material.ns);
    } else if (key == "d") {
        share(material.d);
    } else if (key == "tr") {
        share(material.tr);
    } else if (key == "illum") {
        illumination(material);
    } else if (key == "tf") {
        std::optional<glm::vec3> filter;
        colour(filter);
        if (filter && *filter != glm::vec3(1.0F)) note("Tf is left out: nothing tints light");
    } else if (!map(key, material) && !kOfNoEffect.contains(key)) {
        note("statements of materials that are not known are left out");
    }
}

}  // namespace

std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& file, Notes& notes) {
    return MtlText(text, file, notes).run();
}

}  // namespace obscura::renderer::import_detail
