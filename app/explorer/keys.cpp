// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/keys.h"

// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace obscura::app::explorer {

const std::vector<Key>& keys() {
    static const std::vector<Key> list = {
        {Deed::kHelp, GLFW_KEY_F1, 0, false, false, "F1", "this list"},
        {Deed::kOpen, 0, 'o', true, false, "Ctrl+O", "open a scene or study by its path"},
        {Deed::kSaveImage, 0, 's', true, false, "Ctrl+S", "save the image of A and of B as PNG"},
        {Deed::kSaveBuffers, 0, 'e', true, false, "Ctrl+E", "save the buffers as OpenEXR"},
        {Deed::kSaveToStudy, 0, 't', true, false, "Ctrl+T", "save camera and pair into a study"},
        {Deed::kCopyCost, 0, 'c', true, false, "Ctrl+C", "copy the cost as text"},
        {Deed::kUndo, 0, 'z', true, false, "Ctrl+Z", "undo a change"},
        {Deed::kRedo, 0, 'y', true, false, "Ctrl+Y", "redo it"},
        {Deed::kBack, GLFW_KEY_LEFT, 0, false, true, "Alt+Left", "the view visited before"},
        {Deed::kForward, GLFW_KEY_RIGHT, 0, false, true, "Alt+Right", "the one after"},
        {Deed::kFrameAll, 0, 'f', false, false, "F", "frame the whole scene"},
        {Deed::kNextCamera, 0, 'c', false, false, "C", "the next camera of scene and study"},
        {Deed::kNextArrangement, 0, 'v', false, false, "V", "one, split, four, flicker"},
        {Deed::kOtherSide, 0, 'x', false, false, "X", "A or B in the pane"},
        {Deed::kNextPane, 0, 'n', false, false, "N", "the next pane, for the keys of layers"},
        {Deed::kZoomIn, GLFW_KEY_EQUAL, 0, false, false, "+", "larger pixels"},
        {Deed::kZoomOut, GLFW_KEY_MINUS, 0, false, false, "-", "smaller pixels"},
        {Deed::kWholeImage, GLFW_KEY_HOME, 0, false, false, "Home", "the whole image, no region"},
        {Deed::kTimeAgain, 0, 't', false, false, "T", "time both images again"},
        {Deed::kPanels, GLFW_KEY_F2, 0, false, false, "F2", "show or hide the panels"},
        {Deed::kToPanels, GLFW_KEY_F6, 0, false, false, "F6",
         "into the panels (arrows, Space, Enter) and with Escape back to the image"},
        {Deed::kLargerText, GLFW_KEY_EQUAL, 0, true, false, "Ctrl++", "larger text"},
        {Deed::kSmallerText, GLFW_KEY_MINUS, 0, true, false, "Ctrl+-", "smaller text"},
        {Deed::kFaster, GLFW_KEY_PAGE_UP, 0, false, false, "Page Up", "fly faster"},
        {Deed::kSlower, GLFW_KEY_PAGE_DOWN, 0, false, false, "Page Down", "fly slower"},
        {Deed::kQuit, 0, 'q', true, false, "Ctrl+Q", "quit"},
    };
    return list;
}

std::string key_of(Deed deed) {
    const auto found = std::find_if(keys().begin(), keys().end(),
                                    [deed](const Key& key) { return key.deed == deed; });
    return found != keys().end() ? found->name : "";
}

const std::vector<Motion>& motions() {
    static const std::vector<Motion> list = {
        {"W A S D", "fly ahead, left, back, right"},
        {"Q E", "fly down, up"},
        {"arrows", "turn"},
        {"Shift+arrows", "orbit round what is in the middle"},
        {"1 ... 9, 0", "what the pane shows, in the order of the menu View"},
        {"drag", "turn"},
        {"right drag", "orbit round the point under the pointer"},
        {"middle drag", "move the enlarged image"},
        {"Shift+drag", "mark the region that is measured"},
        {"drag the line", "where A ends and B begins, in the split view"},
        {"wheel", "fly faster or slower"},
        {"Ctrl+wheel", "larger or smaller pixels, about the pointer"},
        {"double click on a slider", "type its value"},
        {"gamepad", "sticks fly and turn, triggers down and up"},
        {"drop a file", "open a .gltf, .glb, .obj or study"},
    };
    return list;
}

}  // namespace obscura::app::explorer
