// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/recipe/recipe.h"

#include <algorithm>
#include <cmath>

namespace obscura::renderer {
namespace {

template <typename List>
auto find(const List& list, std::string_view name) -> decltype(list.data()) {
    for (const auto& item : list) {
        if (item.name == name) return &item;
    }
    return nullptr;
}

}  // namespace

bool Step::reads_buffer(std::string_view buffer) const { return find(reads, buffer) != nullptr; }

bool Recipe::on_processor() const {
    return std::any_of(steps.begin(), steps.end(),
                       [](const Step& step) { return step.processor != nullptr; });
}

bool Recipe::reads(std::string_view name) const {
    return std::any_of(steps.begin(), steps.end(),
                       [name](const Step& step) { return step.reads_buffer(name); });
}

const Buffer* Recipe::find_buffer(std::string_view name) const { return find(buffers, name); }
const NumberTable* Recipe::find_table(std::string_view name) const { return find(tables, name); }

int fetches_per_pixel(const Recipe& recipe) {
    double sum = 0.0;
    for (const Step& step : recipe.steps) {
        const Buffer* own = recipe.find_buffer(step.writes);
        Buffer written = own != nullptr ? *own : Buffer{};
        if (own == nullptr) written.columns = step.columns;
        const int runs = step.frame < 0 ? recipe.frames : 1;
        for (int level = step.first_level; level < step.end_level(written.levels); ++level) {
            const double scale = static_cast<double>(written.scale) * std::pow(0.5, level);
            sum += step.fetches * scale * scale / written.columns * written.layers * runs;
        }
    }
    return static_cast<int>(std::ceil(sum));
}

}  // namespace obscura::renderer
