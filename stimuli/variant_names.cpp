// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/variant_names.h"

#include "renderer/technique/variant_names.h"

namespace obscura::stimuli {
namespace {

class Sides {
  public:
    void add(const std::string& condition, char side, const renderer::Variant& choice) {
        keys_.emplace_back(condition, side);
        choices_.push_back(choice);
    }
    [[nodiscard]] VariantNames names() const {
        const std::vector<std::string> names = renderer::variant_names(choices_);
        VariantNames named;
        for (std::size_t i = 0; i < names.size(); ++i) named.emplace(keys_[i], names[i]);
        return named;
    }

  private:
    std::vector<std::pair<std::string, char>> keys_;
    std::vector<renderer::Variant> choices_;
};

}  // namespace

VariantNames variant_names(const Study& study) {
    Sides sides;
    for (const Condition& condition : study.conditions) {
        sides.add(condition.id, 'a', condition.a);
        sides.add(condition.id, 'b', condition.b);
    }
    return sides.names();
}

VariantNames variant_names(const Manifest& manifest) {
    Sides sides;
    for (const ManifestImage& image : manifest.images) {
        sides.add(image.condition, image.side == "a" ? 'a' : 'b', image.variant);
    }
    return sides.names();
}

}  // namespace obscura::stimuli
