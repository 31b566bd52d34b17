// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/frame/frame.h"
#include "renderer/technique/sampling.h"

namespace obscura::tests {

/// `crytek`, `blizzard` and `raymarch` written out in double precision from their definitions, to
/// hold the shaders against. Rows count from the bottom, as OpenGL stores them.
class TechniqueModel {
  public:
    TechniqueModel(const renderer::Frame& frame, const renderer::Camera& camera)
        : width_(frame.plan().width),
          height_(frame.plan().height),
          far_m_(camera.far_m),
          up_(std::tan(0.5 * camera.vertical_fov_rad)),
          across_(up_ * width_ / height_),
          tile_(renderer::rotation_tile()) {
        const std::vector<std::uint8_t> depth = frame.read_bytes(renderer::Target::kDepth);
        depth_m_.resize(depth.size() / sizeof(float));
        std::memcpy(depth_m_.data(), depth.data(), depth.size());
        if (frame.plan().find(renderer::Target::kNormal) != nullptr) {
            normal_ = frame.read_bytes(renderer::Target::kNormal);
        }
    }

    [[nodiscard]] double depth_m(int x, int y) const { return depth_m_[index(x, y)]; }

    [[nodiscard]] double crytek(int x, int y, int samples, double offset_scale) const {
        const glm::dvec3 r = rotation(x, y);
        // The smallest rotation that takes +Z to r is one; the definition leaves the turn about r
        // open, so the shader's choice is repeated here: columns from Duff et al. 2017.
        const double s = r.z >= 0.0 ? 1.0 : -1.0;
        const double a = -1.0 / (s + r.z);
        const double b = r.x * r.y * a;
        const glm::dmat3 turn(glm::dvec3(1.0 + s * r.x * r.x * a, s * b, -s * r.x),
                              glm::dvec3(b, s + r.y * r.y * a, -r.y), r);
        const double d = depth_m(x, y) / far_m_;
        double scale = offset_scale;
        double sum = 0.0;
        for (int round = 0; round < samples / 8; ++round) {
            for (const double cx : {-1.0, 1.0}) {
                for (const double cy : {-1.0, 1.0}) {
                    for (const double cz : {-1.0, 1.0}) {
                        scale *= 1.0 + 2.4 / samples;
                        const glm::dvec3 o = turn * glm::normalize(glm::dvec3(cx, cy, cz)) * scale;
                        const double ds =
                            seen_m({(x + 0.5) / width_ + o.x, (y + 0.5) / height_ + o.y}) / far_m_;
                        const double visible = ds > d + o.z * d ? 1.0 : 0.0;
                        const double invalid = std::clamp(d - ds, 0.0, 1.0);
                        sum += ds >= 1.0 ? 1.0 : visible * (1.0 - invalid) + 0.5 * invalid;
                    }
                }
            }
        }
        const double mean = sum / samples;
        return std::clamp(mean * mean + mean, 0.0, 1.0);
    }

    struct Curve {
        double radius_m;
        double full_m;
        double no_m;
        double power;
    };
    /// `steps` 1 is blizzard, 4 is raymarch.
    [[nodiscard]] double view_space(int x, int y, int samples, int steps,
                                    const Curve& curve) const {
        const double z = depth_m(x, y);
        const glm::dvec3 p(((x + 0.5) / width_ * 2.0 - 1.0) * across_ * z,
                           ((y + 0.5) / height_ * 2.0 - 1.0) * up_ * z, -z);
        const glm::dvec3 n = normal(x, y);
        const glm::dvec3 r = rotation(x, y);
        double sum = 0.0;
        for (const glm::vec3& point : renderer::ball_kernel(samples)) {
            const glm::dvec3 k(point);
            glm::dvec3 o = k - 2.0 * glm::dot(r, k) * r;
            if (glm::dot(o, n) < 0.0) o = -o;
            double delta = 0.0;
            for (int step = 1; step <= steps; ++step) {
                const glm::dvec3 at = p + o * (curve.radius_m * step / steps);
                delta = at.z < -1e-6 ? std::max(0.0, z - seen_m(project(at))) : 0.0;
                if (delta >= curve.full_m) break;
            }
            const bool open = delta < curve.full_m || delta > curve.no_m;
            sum += open ? 1.0 : std::pow(1.0 / (1.0 + delta * delta), curve.power);
        }
        return sum / samples;
    }

  private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] glm::dvec3 rotation(int x, int y) const { return tile_[4 * (y % 4) + x % 4]; }
    [[nodiscard]] glm::dvec3 normal(int x, int y) const {
        const std::uint8_t* code = &normal_[4 * index(x, y)];
        return glm::normalize(glm::dvec3(code[0] - 128.0, code[1] - 128.0, code[2] - 128.0));
    }
    [[nodiscard]] glm::dvec2 project(const glm::dvec3& point) const {
        return {0.5 + 0.5 * point.x / (-point.z * across_), 0.5 + 0.5 * point.y / (-point.z * up_)};
    }
    /// The depth that the buffer holds there; very far outside the image.
    [[nodiscard]] double seen_m(const glm::dvec2& uv) const {
        if (!(uv.x >= 0.0 && uv.x < 1.0 && uv.y >= 0.0 && uv.y < 1.0)) return 1e18;
        return depth_m(static_cast<int>(uv.x * width_), static_cast<int>(uv.y * height_));
    }

    int width_;
    int height_;
    double far_m_;
    double up_;
    double across_;
    std::vector<glm::vec3> tile_;
    std::vector<float> depth_m_;
    std::vector<std::uint8_t> normal_;
};

}  // namespace obscura::tests
