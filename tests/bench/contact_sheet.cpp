// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Every technique on the built-in study's three scenes, as one PNG to look at: a row a technique,
// the truth first; for each scene accessibility, then the final image.
//   contact_sheet OUT.png [published|fitted]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/measure/measured_scene.h"
#include "renderer/base/files.h"
#include "renderer/gl/context.h"
#include "stimuli/png.h"

namespace {

using namespace obscura;
using namespace obscura::app;

constexpr int kTileWidth = 320;
constexpr int kTileHeight = 180;
constexpr int kRays = 256;

class Sheet {
  public:
    Sheet(int columns, int rows)
        : image_{columns * kTileWidth, rows * kTileHeight,
                 std::vector<std::uint8_t>(static_cast<std::size_t>(3 * columns * kTileWidth) *
                                           static_cast<std::size_t>(rows * kTileHeight))} {}

    void put(int column, int row, const std::vector<std::uint8_t>& rgb) {
        for (int y = 0; y < kTileHeight; ++y) {
            const int at = 3 * ((row * kTileHeight + y) * image_.width + column * kTileWidth);
            std::copy_n(&rgb[static_cast<std::size_t>(3 * y * kTileWidth)], 3 * kTileWidth,
                        &image_.rgb[static_cast<std::size_t>(at)]);
        }
    }
    void put(int column, int row, const std::vector<float>& open) {
        std::vector<std::uint8_t> rgb;
        for (const float value : open) {
            const auto code =
                static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
            rgb.insert(rgb.end(), 3, code);
        }
        put(column, row, rgb);
    }
    [[nodiscard]] const stimuli::RgbImage& image() const { return image_; }

  private:
    stimuli::RgbImage image_;
};

renderer::Variant shown_as(const renderer::Technique& technique, const std::string& preset) {
    renderer::Variant variant = renderer::standard_variant(technique);
    variant.denoise = renderer::standard_denoise(technique);
    if (!technique.fitted.empty()) (void)renderer::apply_preset(preset, variant);
    return variant;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2) return 2;
    const std::string preset = count > 2 ? arguments[2] : "published";
    MeasureRequest request;
    request.quiet = true;
    request.cache = "obscura-data/cache/reference";
    const stimuli::Study study = stimuli::load_study("");
    const std::vector<MeasuredView> views =
        one_a_scene(views_of(request, study, stimuli::builtin_scenes()));
    const renderer::HeadlessContext context;
    MeasuredScene stage(request);
    std::vector<const renderer::Technique*> shown;
    for (const renderer::Technique& technique : renderer::techniques()) {
        if (!technique.is_truth()) shown.push_back(&technique);
    }
    Sheet sheet(2 * static_cast<int>(views.size()), static_cast<int>(shown.size()) + 1);
    for (int v = 0; v < static_cast<int>(views.size()); ++v) {
        const MeasuredView& view = views[static_cast<std::size_t>(v)];
        const renderer::ReferenceImage& truth =
            stage.truth(view, view.radius_m, kTileWidth, kTileHeight, kRays);
        sheet.put(2 * v, 0, truth.accessibility);
        sheet.put(2 * v + 1, 0, stage.true_image(view, truth, view.radius_m));
        for (int i = 0; i < static_cast<int>(shown.size()); ++i) {
            const renderer::Technique& technique = *shown[static_cast<std::size_t>(i)];
            const renderer::Frame frame = stage.render(
                view, on_view(shown_as(technique, preset), view, study), kTileWidth, kTileHeight);
            sheet.put(2 * v, i + 1, frame.read_accessibility());
            sheet.put(2 * v + 1, i + 1, frame.read_display());
        }
    }
    base::write_file_atomically(arguments[1], stimuli::encode_png(sheet.image()));
    fmt::print("row 0: the truth\n");
    for (std::size_t i = 0; i < shown.size(); ++i) {
        fmt::print("row {}: {}\n", i + 1, shown_as(*shown[i], preset).variant_name());
    }
    return 0;
}
