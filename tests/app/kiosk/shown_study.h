// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <string>

#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/random.h"
#include "stimuli/manifest.h"
#include "stimuli/png.h"
#include "stimuli/study.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {

/// A study file with small images of noise and their manifest, in a folder of the test's own that
/// is removed at the end.
class ShownStudy {
  public:
    static constexpr int kWidth = 320;
    static constexpr int kHeight = 200;

    /// `keys` are lines of the table [study].
    ShownStudy(int conditions, int grey_ms, const std::string& keys = "") {
        file = data / "study.toml";
        base::write_file_atomically(file, text_of(conditions, grey_ms, keys));
        study = stimuli::load_study(file.string());
        folder = stimuli::stimuli_folder(data, study);
        make_images();
    }
    [[nodiscard]] std::string store_url() const {
        return "sqlite3://" + (data / "responses.sqlite").string();
    }

    tests::TemporaryFolder temporary;
    std::filesystem::path data = temporary.path();
    std::filesystem::path file;
    std::filesystem::path folder;  ///< of the images
    stimuli::Study study;
    stimuli::Manifest manifest;
    std::map<std::string, stimuli::RgbImage> images;  ///< by the SHA-256 of the file

  private:
    [[nodiscard]] static std::string text_of(int conditions, int grey_ms, const std::string& keys) {
        std::string text = fmt::format(
            "[study]\nname = \"noise\"\ntitle = \"Noise\"\nquestion = \"Which image?\"\n"
            "instructions = \"Look at both \\u2014 \\u017Dlu\\u0165 \\u03BB.\"\n"
            "resolution = [{}, {}]\ngrey_ms = {}\ngrey_level = 128\norder = \"latin-square\"\n"
            "seed = 11\n{}\n[[scene]]\nid = \"r\"\nsource = \"relic\"\ncamera = \"front\"\n"
            "validity = \"low\"\n",
            kWidth, kHeight, grey_ms, keys);
        for (int i = 1; i <= conditions; ++i) {
            text += fmt::format(
                "\n[[condition]]\nid = \"C{}\"\nscene = \"r\"\nhypothesis = \"H1\"\n"
                "a = {{ technique = \"none\" }}\nb = {{ technique = \"crytek\", samples = 8 }}\n",
                i);
        }
        return text;
    }

    void make_images() {
        base::Random random(1);
        manifest = {study.name, study.seed, "a renderer", {}};
        for (const stimuli::Condition& condition : study.conditions) {
            for (const char* side : {"a", "b"}) {
                stimuli::RgbImage pixels{kWidth, kHeight, {}};
                for (int i = 0; i < kWidth * kHeight * 3; ++i) {
                    pixels.rgb.push_back(static_cast<std::uint8_t>(random.below(256)));
                }
                const std::string bytes = stimuli::encode_png(pixels);
                stimuli::ManifestImage image;
                image.file = condition.id + "-" + side + ".png";
                image.sha256 = base::sha256_hex(bytes);
                image.condition = condition.id;
                image.side = side;
                const renderer::Variant& choice =
                    side == std::string("a") ? condition.a : condition.b;
                image.scene = condition.scene;
                image.source = "relic";
                image.camera = "front";
                image.validity = "low";
                image.variant = choice;
                image.width = kWidth;
                image.height = kHeight;
                image.inputs_sha256 = image.sha256;
                base::write_file_atomically(folder / image.file, bytes);
                images[image.sha256] = pixels;
                manifest.images.push_back(image);
            }
        }
        stimuli::save_manifest(folder / "manifest.json", manifest);
    }
};

/// How many of the frame's pixels are not as they must be: the image in the middle of the frame's
/// upper left `width` x `height`, grey around it. No image: all grey. Counts no further than
/// `enough`.
inline int wrong_pixels(const stimuli::RgbImage& screen, const stimuli::RgbImage* image, int width,
                        int height, int grey, int enough = std::numeric_limits<int>::max()) {
    const int left = image == nullptr ? 0 : (width - image->width) / 2;
    const int top = image == nullptr ? 0 : (height - image->height) / 2;
    int wrong = 0;
    for (int y = 0; y < height && wrong < enough; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool inside = image != nullptr && x >= left && x < left + image->width &&
                                y >= top && y < top + image->height;
            for (int channel = 0; channel < 3; ++channel) {
                const int expected =
                    inside ? image->rgb[static_cast<std::size_t>(
                                 ((y - top) * image->width + (x - left)) * 3 + channel)]
                           : grey;
                if (screen.rgb[static_cast<std::size_t>((y * screen.width + x) * 3 + channel)] !=
                    expected) {
                    ++wrong;
                    break;
                }
            }
        }
    }
    return wrong;
}

inline bool shows(const stimuli::RgbImage& screen, const stimuli::RgbImage* image, int width,
                  int height, int grey) {
    if (image != nullptr) {  // the middle tells most images apart
        const auto middle = [](const stimuli::RgbImage& of, int wide, int high) {
            const auto at = static_cast<std::size_t>((high / 2 * of.width + wide / 2) * 3);
            return std::array{of.rgb[at], of.rgb[at + 1], of.rgb[at + 2]};
        };
        if (middle(screen, width, height) != middle(*image, image->width, image->height))
            return false;
    }
    return wrong_pixels(screen, image, width, height, grey, 1) == 0;
}

}  // namespace obscura::app::kiosk
