// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/ray_tree.h"

#include <bit>
#include <map>
#include <memory>

#include "renderer/base/error.h"
#include "renderer/reference/ray_scene.h"

namespace obscura::renderer {
namespace {

glm::uvec4 bits_of(const glm::vec3& v, std::uint32_t last) {
    return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
            std::bit_cast<std::uint32_t>(v.z), last};
}
glm::uvec4 bits_of(const glm::vec2& a, const glm::vec2& b) {
    return bits_of({a.x, a.y, b.x}, std::bit_cast<std::uint32_t>(b.y));
}

/// What the builder makes; it lies in the builder's own memory.
struct BuiltNode {
    RTCBounds bounds[2];
    BuiltNode* children[2];  ///< nothing: a leaf
    const RTCBuildPrimitive* primitives;
    std::size_t count;
};

void* new_node(RTCThreadLocalAllocator allocator, unsigned /*children*/, void* /*user*/) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), 16)) BuiltNode{};
}
void* new_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives,
               std::size_t count, void* /*user*/) {
    auto* const copied = static_cast<RTCBuildPrimitive*>(
        rtcThreadLocalAlloc(allocator, count * sizeof(RTCBuildPrimitive), 32));
    std::copy_n(primitives, count, copied);
    return new (rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), 16))
        BuiltNode{{}, {}, copied, count};
}
void set_children(void* node, void** children, unsigned count, void* /*user*/) {
    for (unsigned i = 0; i < count; ++i) {
        static_cast<BuiltNode*>(node)->children[i] = static_cast<BuiltNode*>(children[i]);
    }
}
void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void* /*user*/) {
    for (unsigned i = 0; i < count; ++i) static_cast<BuiltNode*>(node)->bounds[i] = *bounds[i];
}

class TreeWriter {
  public:
    explicit TreeWriter(const RayScene& scene) : scene_(scene) {}

    RayTree written(const std::vector<RTCBuildPrimitive>& primitives, const BuiltNode& root) {
        if (root.primitives == nullptr) {
            write(root);
        } else {  // one leaf is the first child of a node whose second has no triangles
            tree_.nodes.resize(4);
            set(0, bounds_of(primitives), leaf(root), {}, RayTree::kLeaf);
        }
        return std::move(tree_);
    }

  private:
    static RTCBounds bounds_of(const std::vector<RTCBuildPrimitive>& primitives) {
        RTCBounds all{};
        all.lower_x = all.lower_y = all.lower_z = INFINITY;
        all.upper_x = all.upper_y = all.upper_z = -INFINITY;
        for (const RTCBuildPrimitive& one : primitives) {
            all.lower_x = std::min(all.lower_x, one.lower_x);
            all.lower_y = std::min(all.lower_y, one.lower_y);
            all.lower_z = std::min(all.lower_z, one.lower_z);
            all.upper_x = std::max(all.upper_x, one.upper_x);
            all.upper_y = std::max(all.upper_y, one.upper_y);
            all.upper_z = std::max(all.upper_z, one.upper_z);
        }
        return all;
    }

    void set(std::size_t node, const RTCBounds& a, std::uint32_t first, const RTCBounds& b,
             std::uint32_t second) {
        tree_.nodes[4 * node] = bits_of({a.lower_x, a.lower_y, a.lower_z}, first);
        tree_.nodes[4 * node + 1] = bits_of({a.upper_x, a.upper_y, a.upper_z}, second);
        tree_.nodes[4 * node + 2] = bits_of({b.lower_x, b.lower_y, b.lower_z}, 0);
        tree_.nodes[4 * node + 3] = bits_of({b.upper_x, b.upper_y, b.upper_z}, 0);
    }

    std::uint32_t write(const BuiltNode& node) {
        const std::size_t number = tree_.nodes.size() / 4;
        tree_.nodes.resize(tree_.nodes.size() + 4);
        std::uint32_t children[2];
        for (int i = 0; i < 2; ++i) {
            const BuiltNode& child = *node.children[i];
            children[i] = child.primitives != nullptr ? leaf(child) : write(child);
        }
        set(number, node.bounds[0], children[0], node.bounds[1], children[1]);
        return static_cast<std::uint32_t>(number);
    }

    std::uint32_t leaf(const BuiltNode& node) {
        const std::size_t first = tree_.triangles.size() / 3;
        for (std::size_t i = 0; i < node.count; ++i) {
            add(node.primitives[i].geomID, node.primitives[i].primID);
        }
        return RayTree::kLeaf | static_cast<std::uint32_t>(node.count) << RayTree::kCountShift |
               static_cast<std::uint32_t>(first);
    }

    void add(unsigned geometry, unsigned primitive) {
        const RayScene::Geometry& of = scene_.geometry(geometry);
        const std::uint32_t* const corner = &of.indices[3 * static_cast<std::size_t>(primitive)];
        const glm::vec3 a = of.positions[corner[0]];
        tree_.triangles.push_back(bits_of(a, of.cut_out ? cut_out(geometry, corner) : 0));
        tree_.triangles.push_back(bits_of(of.positions[corner[1]] - a, of.single_sided ? 1 : 0));
        tree_.triangles.push_back(bits_of(of.positions[corner[2]] - a, 0));
    }

    std::uint32_t cut_out(unsigned geometry, const std::uint32_t* corner) {
        const RayScene::Geometry& of = scene_.geometry(geometry);
        tree_.cut_outs.push_back(bits_of(of.uvs[corner[0]], of.uvs[corner[1]]));
        tree_.cut_outs.push_back(bits_of(of.uvs[corner[2]], {of.opacity, of.alpha_cutoff}));
        tree_.cut_outs.emplace_back(first_texel(geometry), of.alpha_width, of.alpha_height, 0);
        return static_cast<std::uint32_t>(tree_.cut_outs.size() / 3);
    }

    std::uint32_t first_texel(unsigned geometry) {
        const auto [found, is_new] = texels_.try_emplace(geometry, 4 * tree_.alpha.size());
        if (!is_new) return static_cast<std::uint32_t>(found->second);
        const std::vector<std::uint8_t>& alpha = scene_.geometry(geometry).alpha;
        const std::size_t first = tree_.alpha.size();
        tree_.alpha.resize(first + (alpha.size() + 3) / 4);
        for (std::size_t i = 0; i < alpha.size(); ++i) {
            tree_.alpha[first + i / 4] |= static_cast<std::uint32_t>(alpha[i]) << 8 * (i % 4);
        }
        return static_cast<std::uint32_t>(found->second);
    }

    const RayScene& scene_;
    RayTree tree_;
    std::map<unsigned, std::size_t> texels_;  ///< the first of a geometry
};

std::vector<RTCBuildPrimitive> primitives_of(const RayScene& scene) {
    std::vector<RTCBuildPrimitive> all;
    for (unsigned geometry = 0; geometry < scene.geometries(); ++geometry) {
        const RayScene::Geometry& of = scene.geometry(geometry);
        for (std::size_t i = 0; i + 2 < of.indices.size(); i += 3) {
            const glm::vec3& a = of.positions[of.indices[i]];
            const glm::vec3& b = of.positions[of.indices[i + 1]];
            const glm::vec3& c = of.positions[of.indices[i + 2]];
            const glm::vec3 low = glm::min(a, glm::min(b, c));
            const glm::vec3 high = glm::max(a, glm::max(b, c));
            all.push_back({low.x, low.y, low.z, geometry, high.x, high.y, high.z,
                           static_cast<unsigned>(i / 3)});
        }
    }
    return all;
}

}  // namespace

std::size_t RayTree::bytes() const {
    return sizeof(glm::uvec4) * (nodes.size() + triangles.size() + cut_outs.size()) +
           sizeof(std::uint32_t) * alpha.size();
}

RayTree ray_tree(const RayScene& scene) {
    const std::vector<RTCBuildPrimitive> primitives = primitives_of(scene);
    if (primitives.size() >= std::size_t{1} << RayTree::kCountShift) {
        throw base::failure("{} triangles are too many for rays on the GPU", primitives.size());
    }
    const std::unique_ptr<std::remove_pointer_t<RTCDevice>, void (*)(RTCDevice)> device(
        rtcNewDevice(nullptr), rtcReleaseDevice);
    const std::unique_ptr<std::remove_pointer_t<RTCBVH>, void (*)(RTCBVH)> memory(
        rtcNewBVH(device.get()), rtcReleaseBVH);
    std::vector<RTCBuildPrimitive> sorted = primitives;
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = RayTree::kDepth;
    arguments.sahBlockSize = 1;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = RayTree::kMostInLeaf;
    arguments.traversalCost = 1.0F;
    arguments.intersectionCost = 1.0F;
    arguments.bvh = memory.get();
    arguments.primitives = sorted.data();
    arguments.primitiveCount = sorted.size();
    arguments.primitiveArrayCapacity = sorted.size();
    arguments.createNode = new_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = new_leaf;
    const auto* const root = static_cast<const BuiltNode*>(rtcBuildBVH(&arguments));
    if (root == nullptr) {
        throw base::failure("Embree cannot build a tree of {} triangles: error {}",
                            primitives.size(), static_cast<int>(rtcGetDeviceError(device.get())));
    }
    return TreeWriter(scene).written(primitives, *root);
}

}  // namespace obscura::renderer
