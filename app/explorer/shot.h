// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/explorer/choices.h"
#include "app/explorer/loaded_scene.h"
#include "renderer/frame/frame.h"
#include "renderer/reference/exr.h"
#include "renderer/scene/scene.h"

namespace obscura::app::explorer {

/// How good an image has to be.
enum class Quality {
    kMoving,  ///< something moves: quick
    kStill,   ///< whole size, one sample a pixel, with every buffer
    kFine,    ///< as the choices say
};

/// Images of one view to render, one after the other.
struct ShotRequest {
    std::uint64_t look = 0;  ///< says what is to be seen; the answers carry it
    Quality quality = Quality::kMoving;
    std::shared_ptr<LoadedScene> scene;
    renderer::Camera camera;
    Choices choices;
    int divisor = 1;       ///< of the image's width and height
    bool buffers = false;  ///< also those beside the image
    bool afresh = false;   ///< every pass runs, to be timed
    std::string sides;     ///< `a`, `b` or both, in this order
};

/// A buffer that a technique or filter has of its own.
struct OwnBuffer {
    std::string name;
    std::string format;
    int width = 0;
    int height = 0;  ///< of one layer
    int layers = 1;
    int channels = 1;
    std::vector<float> values;  ///< pixel by pixel, upper row first, layer after layer
};

/// A rendered image as values.
struct Shot {
    std::uint64_t look = 0;
    Quality quality = Quality::kMoving;
    char side = 'a';
    renderer::Variant variant;
    int width = 0;
    int height = 0;
    int divisor = 1;
    bool coarse = false;  ///< of a scene with fewer triangles, for a moment
    int supersampling = 1;
    std::vector<std::uint8_t> rgb;  ///< sRGB code values, upper row first
    renderer::FloatImage buffers;   ///< stimuli::buffers_of; without channels where not asked for
    std::vector<float> emission;    ///< three a pixel; empty where there is none
    std::vector<OwnBuffer> own;
    std::vector<renderer::PassTime> times;  ///< passes as people are told of them; 0 where untimed
    std::vector<renderer::PlannedTarget> buffers_planned;
    std::size_t bytes = 0;  ///< of the plan's buffers
    std::vector<renderer::LeftOut> left_out;
    int fetches = 0;          ///< a pixel, of technique and filter
    double milliseconds = 0;  ///< of everything: passes and reading back
};

}  // namespace obscura::app::explorer
