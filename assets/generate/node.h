#pragma once

#include <string>

#include "assets/scene.h"

namespace rambla::assets::generate {

/// Adds a node under `parent`, or one without parent (which is not made a root), and returns its index.
inline std::uint32_t add_node(Scene& scene, const std::string& name, std::uint32_t parent,
                              const Transform& local) {
    const auto index = static_cast<std::uint32_t>(scene.nodes.size());
    Node node;
    node.name = name;
    node.parent = parent;
    node.local = local;
    scene.nodes.push_back(std::move(node));
    if (parent != k_none) scene.nodes[parent].children.push_back(index);
    return index;
}

}  // namespace rambla::assets::generate
