// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/support/texture_maker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace obscura::stimuli {
namespace {

float srgb_from_linear(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

/// The code values of linear k / 65535; a table, because textures encode millions of values.
const std::vector<std::uint8_t>& srgb_table() {
    static const std::vector<std::uint8_t> table = [] {
        std::vector<std::uint8_t> codes(65536);
        for (std::size_t k = 0; k < codes.size(); ++k) {
            const float code = srgb_from_linear(static_cast<float>(k) / 65535.0F) * 255.0F;
            codes[k] = static_cast<std::uint8_t>(std::lround(code));
        }
        return codes;
    }();
    return table;
}

/// -1 to 1 as 1 to 255, 128 = 0.
std::uint8_t encode_signed(float value) {
    return static_cast<std::uint8_t>(std::clamp(value, -1.0F, 1.0F) * 127.0F + 128.5F);
}

/// [0, 1] as 0 to 255.
std::uint8_t encode_unit(float value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F);
}

renderer::Texture blank(const TextureRecipe& recipe, const char* suffix, bool srgb) {
    renderer::Texture texture;
    texture.name = recipe.name + suffix;
    texture.width = recipe.width;
    texture.height = recipe.height;
    texture.srgb = srgb;
    texture.rgba.resize(4 * static_cast<std::size_t>(recipe.width) *
                        static_cast<std::size_t>(recipe.height));
    return texture;
}

}  // namespace

void for_each_row(int rows, const std::function<void(int)>& row) {
    const int threads =
        std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, std::max(1, rows));
    std::atomic<int> next{0};
    std::exception_ptr error;
    std::mutex error_lock;
    const auto work = [&] {
        try {
            for (int y = next++; y < rows; y = next++) row(y);
        } catch (...) {
            const std::lock_guard guard(error_lock);
            error = std::current_exception();
        }
    };
    // Calls within calls share what threads there may be.
    static std::atomic<int> helping{0};
    const int most = 2 * static_cast<int>(std::thread::hardware_concurrency());
    std::vector<std::thread> helpers;
    while (static_cast<int>(helpers.size()) < threads - 1 && helping < most) {
        try {
            helpers.emplace_back(work);
        } catch (const std::system_error&) {
            break;  // those that there are do it
        }
        ++helping;
    }
    work();
    for (std::thread& helper : helpers) helper.join();
    helping -= static_cast<int>(helpers.size());
    if (error) std::rethrow_exception(error);
}

std::uint8_t encode_srgb(float linear) {
    const float clamped = std::clamp(linear, 0.0F, 1.0F);
    return srgb_table()[static_cast<std::size_t>(clamped * 65535.0F + 0.5F)];
}

glm::vec3 linear_from_srgb(std::uint32_t rgb) {
    const auto channel = [&](int shift) {
        const float code = static_cast<float>((rgb >> shift) & 255U) / 255.0F;
        return code <= 0.04045F ? code / 12.92F : std::pow((code + 0.055F) / 1.055F, 2.4F);
    };
    return {channel(16), channel(8), channel(0)};
}

BakedTextures bake(const TextureRecipe& recipe) {
    const int width = recipe.width;
    const int height = recipe.height;
    BakedTextures baked{blank(recipe, "-albedo", true), blank(recipe, "-normal", false), {}};
    if (recipe.roughness) baked.roughness = blank(recipe, "-roughness", false);
    std::vector<float> heights_m(static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(height));
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>((y + height) % height) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>((x + width) % width);
    };
    for_each_row(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const Texel texel =
                recipe.at({(static_cast<float>(x) + 0.5F) / static_cast<float>(width),
                           (static_cast<float>(y) + 0.5F) / static_cast<float>(height)});
            const std::size_t i = index(x, y);
            heights_m[i] = texel.height_m;
            for (int c = 0; c < 3; ++c)
                baked.albedo.rgba[4 * i + static_cast<std::size_t>(c)] =
                    encode_srgb(texel.albedo[c]);
            baked.albedo.rgba[4 * i + 3] = encode_unit(texel.opacity);
            if (baked.roughness) {
                const std::uint8_t code = encode_unit(texel.roughness);
                const std::array<std::uint8_t, 4> stored{0, code, 0, 255};
                std::copy(stored.begin(), stored.end(), &baked.roughness->rgba[4 * i]);
            }
        }
    });
    const glm::vec2 two_texels_m =
        2.0F * recipe.size_m / glm::vec2(static_cast<float>(width), static_cast<float>(height));
    for_each_row(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const float du = (heights_m[index(x + 1, y)] - heights_m[index(x - 1, y)]);
            const float dv = (heights_m[index(x, y + 1)] - heights_m[index(x, y - 1)]);
            const glm::vec3 normal =
                glm::normalize(glm::vec3(-du / two_texels_m.x, -dv / two_texels_m.y, 1.0F));
            std::uint8_t* texel = &baked.normal.rgba[4 * index(x, y)];
            for (int c = 0; c < 3; ++c) texel[c] = encode_signed(normal[c]);
            texel[3] = 255;
        }
    });
    return baked;
}

std::uint32_t add_material(renderer::Scene& scene, renderer::Material material,
                           const TextureRecipe& recipe) {
    BakedTextures baked = bake(recipe);
    material.albedo_texture = static_cast<renderer::TextureIndex>(scene.textures.size());
    scene.textures.push_back(std::move(baked.albedo));
    material.normal_texture = static_cast<renderer::TextureIndex>(scene.textures.size());
    scene.textures.push_back(std::move(baked.normal));
    if (baked.roughness) {
        material.roughness_texture = static_cast<renderer::TextureIndex>(scene.textures.size());
        scene.textures.push_back(std::move(*baked.roughness));
    }
    scene.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

}  // namespace obscura::stimuli
