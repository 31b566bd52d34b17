// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/typesetter.h"

#include <epoxy/gl.h>
#include <pango/pangocairo.h>
#include <unicode/uchar.h>
#include <utf8.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace obscura::app::kiosk {

/// Gives back what a C library lent.
template <auto Unref>
struct Unreferenced {
    template <typename T>
    void operator()(T* pointer) const {
        Unref(pointer);
    }
};

using FontMap = std::unique_ptr<PangoFontMap, Unreferenced<g_object_unref>>;
using Context = std::unique_ptr<PangoContext, Unreferenced<g_object_unref>>;
using LaidOut = std::unique_ptr<PangoLayout, Unreferenced<g_object_unref>>;

namespace {

/// Of DejaVu Sans: ascender and descender over the em, which is what fonts are sized by.
constexpr float kLineOverEm = 1.164F;
/// A texture is at most that high; every OpenGL has four times as much.
constexpr int kTileHeight_px = 4096;
constexpr const char* kFamily = "DejaVu Sans";

using Surface = std::unique_ptr<cairo_surface_t, Unreferenced<cairo_surface_destroy>>;
using Cairo = std::unique_ptr<cairo_t, Unreferenced<cairo_destroy>>;

[[nodiscard]] bool runs_from_the_right(char32_t character) {
    const UCharDirection direction = u_charDirection(static_cast<UChar32>(character));
    return direction == U_RIGHT_TO_LEFT || direction == U_RIGHT_TO_LEFT_ARABIC;
}

/// What is no UTF-8, as in the name of a file, is shown by U+FFFD.
[[nodiscard]] std::string valid_utf8(const std::string& text) {
    std::string valid;
    utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
    return valid;
}

[[nodiscard]] std::u32string characters_in(const std::string& text) {
    std::u32string characters;
    utf8::utf8to32(text.begin(), text.end(), std::back_inserter(characters));
    return characters;
}

/// Cairo's colours are multiplied with their alpha, Dear ImGui's are not.
[[nodiscard]] std::vector<std::uint8_t> straight_rgba(cairo_surface_t* surface) {
    const int width = cairo_image_surface_get_width(surface);
    const int height = cairo_image_surface_get_height(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    const std::uint8_t* data = cairo_image_surface_get_data(surface);
    std::vector<std::uint8_t> rgba;
    rgba.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4U);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint32_t pixel = 0;
            std::copy_n(data + y * stride + x * 4, 4, reinterpret_cast<std::uint8_t*>(&pixel));
            const std::uint32_t alpha = pixel >> 24U;
            for (const unsigned shift : {16U, 8U, 0U}) {
                const std::uint32_t value = (pixel >> shift) & 0xFFU;
                rgba.push_back(static_cast<std::uint8_t>(
                    alpha == 0 ? 0 : std::min(255U, (value * 255U + alpha / 2) / alpha)));
            }
            rgba.push_back(static_cast<std::uint8_t>(alpha));
        }
    }
    return rgba;
}

/// The pixels of a layout within that rectangle.
[[nodiscard]] unsigned draw_texture(PangoLayout* layout, const PangoRectangle& part,
                                    unsigned colour) {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, part.width, part.height));
    const Cairo cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), -part.x, -part.y);
    const auto channel = [colour](unsigned shift) {
        return static_cast<double>((colour >> shift) & 0xFFU) / 255.0;
    };
    cairo_set_source_rgba(cairo.get(), channel(0), channel(8), channel(16), channel(24));
    pango_cairo_show_layout(cairo.get(), layout);
    cairo_surface_flush(surface.get());
    const std::vector<std::uint8_t> pixels = straight_rgba(surface.get());
    unsigned texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA8, part.width, part.height);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(texture, 0, 0, 0, part.width, part.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels.data());
    return texture;
}

}  // namespace

struct Typesetter::Pango {
    FontMap fonts{pango_cairo_font_map_new()};
    Context context{pango_font_map_create_context(fonts.get())};
    bool right_to_left = false;

    [[nodiscard]] LaidOut lay_out(const std::string& given, const Setting& setting) const {
        const std::string text = valid_utf8(given);
        LaidOut layout(pango_layout_new(context.get()));
        PangoFontDescription* font = pango_font_description_new();
        pango_font_description_set_family_static(font, kFamily);
        pango_font_description_set_absolute_size(
            font, std::round(static_cast<double>(setting.text_px / kLineOverEm) * PANGO_SCALE));
        pango_layout_set_font_description(layout.get(), font);
        pango_font_description_free(font);
        pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
        pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
        pango_layout_set_spacing(
            layout.get(), static_cast<int>(std::round(setting.between_lines_px)) * PANGO_SCALE);
        if (setting.width_px > 0.0F) {
            pango_layout_set_width(layout.get(), static_cast<int>(setting.width_px) * PANGO_SCALE);
        }
        // A sentence of a language from right to left stays one where it begins with a Latin word.
        const auto characters = characters_in(text);
        const bool of_the_page =
            right_to_left && std::any_of(characters.begin(), characters.end(), runs_from_the_right);
        pango_layout_set_auto_dir(layout.get(), of_the_page ? FALSE : TRUE);
        // Pango's left is where the context's own direction begins.
        pango_layout_set_alignment(layout.get(), setting.centred ? PANGO_ALIGN_CENTER
                                                 : right_to_left ? PANGO_ALIGN_RIGHT
                                                                 : PANGO_ALIGN_LEFT);
        return layout;
    }
};

Typesetter::Typesetter(const std::string& language, bool right_to_left, Draws draws)
    : pango_(std::make_unique<Pango>()), draws_(draws) {
    PangoContext* context = pango_->context.get();
    pango_->right_to_left = right_to_left;
    pango_context_set_language(context, pango_language_from_string(language.c_str()));
    pango_context_set_base_dir(context, right_to_left ? PANGO_DIRECTION_RTL : PANGO_DIRECTION_LTR);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_SLIGHT);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_ON);
    pango_cairo_context_set_font_options(context, options);
    cairo_font_options_destroy(options);
}

Typesetter::~Typesetter() {
    for (const auto& [key, entry] : entries_) free(entry.text);
}

void Typesetter::free(const SetText& text) const {
    for (const TextTile& tile : text.tiles) {
        if (tile.texture != 0) glDeleteTextures(1, &tile.texture);
    }
}

const SetText& Typesetter::set(const std::string& text, const Setting& setting) {
    const auto [found, is_new] = entries_.try_emplace({text, setting});
    Entry& entry = found->second;
    entry.pages_ago = 0;
    if (is_new) entry.text = make(text, setting);
    const auto& tiles = entry.text.tiles;
    uses_.push_back({text, setting.colour, tiles.empty() ? 0 : tiles.front().texture});
    return entry.text;
}

SetText Typesetter::make(const std::string& text, const Setting& setting) const {
    const LaidOut layout = pango_->lay_out(text, setting);
    PangoRectangle ink;
    PangoRectangle line;
    pango_layout_get_pixel_extents(layout.get(), &ink, &line);
    SetText made{static_cast<float>(line.x),
                 static_cast<float>(line.width),
                 static_cast<float>(line.height),
                 {}};
    if (draws_ == Draws::kNothing || ink.width <= 0) return made;
    for (int top = 0; top < ink.height; top += kTileHeight_px) {
        const PangoRectangle part{ink.x, ink.y + top, ink.width,
                                  std::min(kTileHeight_px, ink.height - top)};
        made.tiles.push_back({draw_texture(layout.get(), part, setting.colour),
                              static_cast<float>(part.x - line.x),
                              static_cast<float>(part.y - line.y), static_cast<float>(part.width),
                              static_cast<float>(part.height)});
    }
    return made;
}

void Typesetter::forget_unused() {
    // The pages of a pair come again with each pair, and are not set anew.
    constexpr int kKept = 6;
    for (auto at = entries_.begin(); at != entries_.end();) {
        if (at->second.pages_ago++ < kKept) {
            ++at;
        } else {
            free(at->second.text);
            at = entries_.erase(at);
        }
    }
}

float Typesetter::caret_px(const std::string& text, float text_px, std::size_t byte) {
    const LaidOut layout = pango_->lay_out(text, {.text_px = text_px});
    PangoRectangle strong;
    pango_layout_get_cursor_pos(layout.get(), static_cast<int>(byte), &strong, nullptr);
    return static_cast<float>(strong.x) / PANGO_SCALE;
}

std::size_t Typesetter::byte_at(const std::string& text, float text_px, float x_px) {
    const LaidOut layout = pango_->lay_out(text, {.text_px = text_px});
    int index = 0;
    int trailing = 0;
    pango_layout_xy_to_index(layout.get(), static_cast<int>(x_px * PANGO_SCALE), 0, &index,
                             &trailing);
    const char* at = text.c_str() + index;
    while (trailing-- > 0 && *at != '\0') at = g_utf8_next_char(at);
    return static_cast<std::size_t>(at - text.c_str());
}

std::set<char32_t> Typesetter::characters_without_glyph(const std::string& text) {
    const auto unknown = [this](const std::string& part) {
        const LaidOut layout = pango_->lay_out(part, {});
        return pango_layout_get_unknown_glyphs_count(layout.get());
    };
    std::set<char32_t> missing;
    if (unknown(text) == 0) return missing;
    const std::u32string characters = characters_in(valid_utf8(text));
    for (const char32_t character : std::set<char32_t>(characters.begin(), characters.end())) {
        std::string bytes;
        utf8::append(character, bytes);
        if (unknown(bytes) > 0) missing.insert(character);
    }
    return missing;
}

}  // namespace obscura::app::kiosk
