// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/gltf_nodes.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace obscura::renderer::import_detail {
namespace {

constexpr std::size_t kNoNode = ~std::size_t{0};

glm::dmat4 parent_from_node(const JsonCursor& node) {
    if (node.find("matrix")) {
        const auto m = node.numbers("matrix", std::vector<double>(16, 0.0));
        glm::dmat4 matrix(1.0);
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
        // The last row of a placement is 0 0 0 1 whatever the file says.
        for (int column = 0; column < 4; ++column) matrix[column][3] = column == 3 ? 1.0 : 0.0;
        return matrix;
    }
    const auto t = node.numbers("translation", {0.0, 0.0, 0.0});
    const auto r = node.numbers("rotation", {0.0, 0.0, 0.0, 1.0});
    const auto s = node.numbers("scale", {1.0, 1.0, 1.0});
    glm::dquat turn(r[3], r[0], r[1], r[2]);
    const double length = glm::length(turn);
    turn = length > 0.0 ? turn / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
    return glm::translate(glm::dmat4(1.0), glm::dvec3(t[0], t[1], t[2])) * glm::mat4_cast(turn) *
           glm::scale(glm::dmat4(1.0), glm::dvec3(s[0], s[1], s[2]));
}

using Children = std::vector<std::vector<std::size_t>>;

/// The children of every node, and in `parents` the parent of each or kNoNode.
Children read_children(const JsonCursor& root, std::vector<std::size_t>& parents) {
    const std::size_t count = root.count("nodes");
    Children children(count);
    parents.assign(count, kNoNode);
    for (std::size_t i = 0; i < count; ++i) {
        const auto list = root.at("nodes").item(i).find("children");
        if (!list) continue;
        for (std::size_t k = 0; k < list->count(); ++k) {
            const JsonCursor item = list->item(k);
            const std::size_t child = item.index(count, "nodes");
            if (parents[child] != kNoNode) {
                item.fail(
                    fmt::format("node {} is a child of node {} already, allowed is one "
                                "parent",
                                child, parents[child]));
            }
            parents[child] = i;
            children[i].push_back(child);
        }
    }
    return children;
}

/// `first` and all below it, parents before children.
void add_with_children(std::size_t first, const Children& children,
                       std::vector<std::size_t>& list) {
    std::size_t next = list.size();
    for (list.push_back(first); next < list.size(); ++next) {
        const std::vector<std::size_t>& below = children[list[next]];
        list.insert(list.end(), below.begin(), below.end());
    }
}

}  // namespace

GltfNodes read_nodes(const GltfFile& file, double scale, Notes& notes) {
    const JsonCursor root = file.root();
    std::vector<std::size_t> parents;
    const Children children = read_children(root, parents);
    const std::size_t count = children.size();
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < count; ++i) {
        if (parents[i] == kNoNode) add_with_children(i, children, order);
    }
    if (order.size() != count) root.at("nodes").fail("some node is its own ancestor");

    GltfNodes nodes;
    nodes.world_from_node.resize(count);
    const glm::dmat4 metres = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
    for (const std::size_t i : order) {
        const glm::dmat4& parent =
            parents[i] == kNoNode ? metres : nodes.world_from_node[parents[i]];
        nodes.world_from_node[i] = parent * parent_from_node(root.at("nodes").item(i));
    }
    const std::size_t scenes = root.count("scenes");
    if (scenes == 0) {
        nodes.shown = order;
        return nodes;
    }
    const std::size_t chosen = root.index("scene", scenes, "scenes").value_or(0);
    if (scenes > 1) {
        notes.add(fmt::format("the file has {} scenes, the one shown is", scenes),
                  fmt::format("scene {}", chosen));
    }
    const auto list = root.at("scenes").item(chosen).find("nodes");
    std::vector<bool> taken(count, false);
    for (std::size_t k = 0; list && k < list->count(); ++k) {
        const std::size_t node = list->item(k).index(count, "nodes");
        if (taken[node]) continue;
        const std::size_t before = nodes.shown.size();
        add_with_children(node, children, nodes.shown);
        for (std::size_t i = before; i < nodes.shown.size(); ++i) {
            if (taken[nodes.shown[i]]) list->item(k).fail("a node below another of the scene's");
            taken[nodes.shown[i]] = true;
        }
    }
    return nodes;
}

}  // namespace obscura::renderer::import_detail
