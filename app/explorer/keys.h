// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace obscura::app::explorer {

/// What a key does at once. Flying goes on while its keys are held, and is listed here too.
enum class Deed {
    kHelp,
    kOpen,
    kSaveImage,
    kSaveBuffers,
    kSaveToStudy,
    kCopyCost,
    kUndo,
    kRedo,
    kBack,
    kForward,
    kFrameAll,
    kNextCamera,
    kNextArrangement,
    kOtherSide,
    kNextPane,
    kZoomIn,
    kZoomOut,
    kWholeImage,
    kTimeAgain,
    kPanels,
    kToPanels,
    kLargerText,
    kSmallerText,
    kQuit,
    kFaster,
    kSlower,
};

/// A key with what it does.
struct Key {
    Deed deed;
    int key = 0;      ///< GLFW_KEY_..., by its place on a US keyboard
    char letter = 0;  ///< the key that types this letter, whatever the layout
    bool control = false;
    bool alt = false;
    std::string name;  ///< for people: Ctrl+S
    std::string does;  ///< a sentence's part
};
[[nodiscard]] const std::vector<Key>& keys();

/// The key's name for people.
[[nodiscard]] std::string key_of(Deed deed);

/// What is not a single key: name and what it does, for the list of keys.
struct Motion {
    std::string name;
    std::string does;
};
[[nodiscard]] const std::vector<Motion>& motions();

}  // namespace obscura::app::explorer
