// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Keys on the screen, for those who have a mouse or a finger only.
#include <imgui.h>
#include <imgui_internal.h>
#include <unicode/uchar.h>
#include <unicode/unorm2.h>
#include <utf8.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

/// Times the text's height.
constexpr float kKeySide = 2.0F;
constexpr float kKeysApart = 0.2F;
constexpr float kBlankKeys = 5.0F;  ///< width of the blank, in keys
/// What comes into view with the keys: the field and its label.
constexpr float kSeenAbove = 4.5F;
constexpr int kFramesToReveal = 4;

constexpr char32_t kGap = U'\u3000';  ///< a place of a row without a key
constexpr const char* kLatin = "qwertyuiop asdfghjkl zxcvbnm";
constexpr std::u32string_view kDigits = U"1234567890";
constexpr std::u32string_view kMarks = U"-'.,";

using Rows = std::vector<std::u32string>;

[[nodiscard]] Rows rows_of(const std::string& letters) {
    std::u32string all;
    utf8::utf8to32(letters.begin(), letters.end(), std::back_inserter(all));
    Rows rows(1);
    for (const char32_t letter : all) {
        if (letter == U' ') {
            rows.emplace_back();
        } else {
            rows.back() += letter;
        }
    }
    std::erase_if(rows, [](const auto& row) { return row.empty(); });
    return rows;
}

struct Letters {
    Rows shown;
    Rows others;  ///< a key changes to them; none where the page's language is written in Latin
};

[[nodiscard]] bool is_latin(const Rows& rows) {
    return std::any_of(rows.begin(), rows.end(), [](const std::u32string& row) {
        return row.find(U'a') != std::u32string::npos;
    });
}

[[nodiscard]] Letters letters_of(const std::string& own_letters, KeypadLetters first,
                                 bool changed) {
    Rows own = rows_of(own_letters);
    Rows latin = rows_of(kLatin);
    if (is_latin(own)) return {std::move(own), {}};
    if (changed != (first == KeypadLetters::kLatin)) return {std::move(latin), std::move(own)};
    return {std::move(own), std::move(latin)};
}

[[nodiscard]] char32_t capital(char32_t letter) {
    return static_cast<char32_t>(u_toupper(static_cast<UChar32>(letter)));
}

/// On the key that leads to these letters; empty: there are none.
[[nodiscard]] std::string change_label(const Rows& letters) {
    if (letters.empty()) return "";
    return is_latin(letters) ? "ABC" : utf8::utf32to8(letters[0].substr(0, 3));
}

/// A letter that has a capital; 0: none has.
[[nodiscard]] char32_t letter_with_case(const Rows& rows) {
    char32_t found = 0;
    for (const std::u32string& row : rows) {
        for (const char32_t letter : row) {
            if (letter == U'a') return letter;
            if (found == 0 && capital(letter) != letter) found = letter;
        }
    }
    return found;
}

/// A sound mark goes onto the kana before it.
[[nodiscard]] char32_t combining(char32_t character) {
    if (character == U'\u309B') return U'\u3099';
    return character == U'\u309C' ? U'\u309A' : character;
}

void type_key(TextEntry& entry, char32_t character) {
    UErrorCode error = U_ZERO_ERROR;
    const UNormalizer2* composed = unorm2_getNFCInstance(&error);
    if (U_SUCCESS(error) && entry.caret() > 0) {
        const char32_t before = entry.text()[entry.caret() - 1];
        const UChar32 both = unorm2_composePair(composed, static_cast<UChar32>(before),
                                                static_cast<UChar32>(combining(character)));
        if (both >= 0) {
            entry.erase_before();
            entry.type(static_cast<char32_t>(both));
            return;
        }
    }
    entry.type(character);
}

/// Rows of keys in the middle of the page's width.
class Keys {
  public:
    explicit Keys(std::size_t most)
        : room_px_(ImGui::GetContentRegionAvail().x), left_px_(ImGui::GetCursorPosX()) {
        const auto count = static_cast<float>(most);
        const float fitting = (room_px_ + apart()) / count - apart();
        side_px_ = std::floor(std::min(times_text(kKeySide), fitting));
    }
    /// So many keys follow, with `more_px` of other widths beside them.
    void begin_row(float keys, float more_px = 0.0F) {
        const float width = keys * (side_px_ + apart()) - apart() + more_px;
        ImGui::SetCursorPosX(left_px_ + std::round(0.5F * (room_px_ - width)));
        first_ = true;
    }
    [[nodiscard]] bool key(const std::string& label, float width_px = 0.0F) {
        if (!std::exchange(first_, false)) ImGui::SameLine(0.0F, apart());
        return pad_button(label, width_px > 0.0F ? width_px : side_px_);
    }
    void gap() {
        if (!std::exchange(first_, false)) ImGui::SameLine(0.0F, apart());
        ImGui::Dummy({side_px_, ImGui::GetFrameHeight()});
    }
    [[nodiscard]] float side_px() const { return side_px_; }
    [[nodiscard]] static float apart() { return times_text(kKeysApart); }

  private:
    float room_px_;
    float left_px_;
    float side_px_;
    bool first_ = true;
};

void row_of_keys(Keys& keys, std::u32string_view row, bool capitals, TextEntry& entry,
                 KeypadState& state) {
    keys.begin_row(static_cast<float>(row.size()));
    for (const char32_t letter : row) {
        if (letter == kGap) {
            keys.gap();
            continue;
        }
        const char32_t shown = capitals ? capital(letter) : letter;
        if (!keys.key(utf8_of(shown))) continue;
        type_key(entry, shown);
        state.capitals = false;
        state.pressed = true;
    }
}

/// Capitals, other letters, marks, the blank, and the way back.
void last_row(Keys& keys, const Rows& letters, const Rows& others, TextEntry& entry,
              KeypadState& state) {
    const char32_t cased = letter_with_case(letters);
    const std::string change = change_label(others);
    // Of more than one letter, which stay on one line.
    const float change_px = std::round(1.7F * keys.side_px());
    const float blank_px = kBlankKeys * keys.side_px();
    const int changes = (cased != 0 ? 1 : 0) + (change.empty() ? 0 : 1);
    const float wide =
        blank_px + Keys::apart() + static_cast<float>(changes) * (change_px + Keys::apart());
    keys.begin_row(static_cast<float>(kMarks.size()) + 1.0F, wide);
    const auto pressed = [&](const std::string& label, float width_px = 0.0F) {
        const bool is = keys.key(label, width_px);
        state.pressed = state.pressed || is;
        return is;
    };
    if (cased != 0 && pressed(utf8_of(capital(cased)) + utf8_of(cased), change_px)) {
        state.capitals = !state.capitals;
    }
    if (!change.empty() && pressed(change, change_px)) state.changed = !state.changed;
    for (const char32_t mark : kMarks.substr(0, 2)) {
        if (pressed(utf8_of(mark))) type_key(entry, mark);
    }
    if (pressed(" ", blank_px)) entry.type(U' ');
    for (const char32_t mark : kMarks.substr(2)) {
        if (pressed(utf8_of(mark))) type_key(entry, mark);
    }
    if (pressed("\u2190")) entry.erase_before();
}

}  // namespace

void keypad(const char* name, TextEntry& entry, KeypadLetters first) {
    PageState& page = page_state();
    KeypadState& state = page.keypad;
    const ImGuiID field = ImGui::GetID(name);
    if (state.field != field) return;
    const auto [letters, others] = letters_of(words()("keypad_letters"), first, state.changed);
    std::size_t most = kDigits.size();
    for (const std::u32string& row : letters) most = std::max(most, row.size());
    const float top = ImGui::GetCursorScreenPos().y - times_text(kSeenAbove);
    ImGui::PushID(name);
    ImGui::BeginGroup();
    Keys keys(most);
    row_of_keys(keys, kDigits, false, entry, state);
    for (std::size_t row = 0; row < letters.size(); ++row) {
        ImGui::PushID(static_cast<int>(row));
        row_of_keys(keys, letters[row], state.capitals, entry, state);
        ImGui::PopID();
    }
    last_row(keys, letters, others, entry, state);
    ImGui::EndGroup();
    ImGui::PopID();
    // What is typed next goes there from the keyboard too.
    if (std::exchange(state.pressed, false)) page.focus = field;
    if (state.frames < kFramesToReveal) {
        ++state.frames;
        const ImVec2 from = ImGui::GetItemRectMin();
        const ImVec2 to = ImGui::GetItemRectMax();
        ImGui::ScrollToRect(ImGui::GetCurrentWindow(), {from.x, top, to.x, to.y + times_text(0.3F)},
                            ImGuiScrollFlags_KeepVisibleEdgeY);
    }
}

}  // namespace obscura::app::kiosk
