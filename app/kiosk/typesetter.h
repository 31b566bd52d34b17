// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace obscura::app::kiosk {

/// How a text is to be set.
struct Setting {
    float text_px = 16.0F;  ///< height of a line of DejaVu Sans, as Dear ImGui counts it
    float width_px = 0.0F;  ///< lines break there; 0: one line
    float between_lines_px = 0.0F;
    unsigned colour = 0;   ///< as Dear ImGui packs it (IM_COL32)
    bool centred = false;  ///< else each paragraph begins at its own side
    auto operator<=>(const Setting&) const = default;
};

/// A part of a set text as a texture; places are relative to the text's upper left corner.
struct TextTile {
    unsigned texture = 0;  ///< OpenGL's name
    float left_px = 0.0F;
    float top_px = 0.0F;
    float width_px = 0.0F;
    float height_px = 0.0F;
};

/// A text in its place: from `left_px` on within the width it was set for.
struct SetText {
    float left_px = 0.0F;
    float width_px = 0.0F;
    float height_px = 0.0F;
    std::vector<TextTile> tiles;
};

/// Sets texts of any script by Pango: shaping, right to left, line breaking, and a font for every
/// character that one of this machine has. Everything is in whole pixels, so that it is drawn
/// crisp.
class Typesetter {
  public:
    enum class Draws { kTextures, kNothing };

    /// `language` (BCP 47) decides between the shapes that a character has in several. Textures
    /// need a current OpenGL context, now and until it is destroyed; without them texts only have
    /// their size.
    Typesetter(const std::string& language, bool right_to_left, Draws draws);
    ~Typesetter();
    Typesetter(const Typesetter&) = delete;
    Typesetter& operator=(const Typesetter&) = delete;

    /// Valid until forget_unused().
    [[nodiscard]] const SetText& set(const std::string& text, const Setting& setting);
    /// To be called when a page begins; frees what the last few pages did not have.
    void forget_unused();

    /// Where the caret stands before the byte at that index of one line, from its left.
    [[nodiscard]] float caret_px(const std::string& text, float text_px, std::size_t byte);
    /// The place between characters, in bytes, nearest to there.
    [[nodiscard]] std::size_t byte_at(const std::string& text, float text_px, float x_px);

    /// The characters of a text (UTF-8) that no font of this machine draws.
    [[nodiscard]] std::set<char32_t> characters_without_glyph(const std::string& text);

    /// A text that was set, its colour and its first texture.
    struct Use {
        std::string text;
        unsigned colour = 0;
        unsigned texture = 0;
    };
    /// Those of the frame since note_uses(), in order.
    [[nodiscard]] const std::vector<Use>& uses() const { return uses_; }
    void note_uses() { uses_.clear(); }

  private:
    struct Pango;
    struct Entry {
        SetText text;
        int pages_ago = 0;
    };
    [[nodiscard]] SetText make(const std::string& text, const Setting& setting) const;
    void free(const SetText& text) const;

    std::unique_ptr<Pango> pango_;
    Draws draws_;
    std::map<std::pair<std::string, Setting>, Entry> entries_;
    std::vector<Use> uses_;
};

}  // namespace obscura::app::kiosk
