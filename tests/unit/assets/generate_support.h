#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "assets/generate/places.h"

namespace rambla::assets::test {

/// The standard street, generated once for all tests of a program.
inline const Place& street() {
    static const Place place = generate_place("street", 1);
    return place;
}

/// A model shown somewhere.
struct Shown {
    std::string root;
    std::uint32_t model = k_none;
    glm::mat4 world_from_local{1.0f};
};

/// Everything that stands in the scene by default.
inline std::vector<Shown> shown_models(const Scene& scene) {
    std::vector<Shown> all;
    const std::function<void(std::uint32_t, const std::string&, const glm::mat4&)> visit =
        [&](std::uint32_t index, const std::string& root, const glm::mat4& parent) {
            const Node& node = scene.nodes[index];
            const glm::mat4 here = parent * matrix(node.local);
            if (node.model != k_none) all.push_back({root, node.model, here});
            for (const std::uint32_t child : node.children)
                visit(child, root, here);
        };
    for (const std::uint32_t root : scene.roots)
        visit(root, scene.nodes[root].name, glm::mat4{1.0f});
    return all;
}

/// FNV-1a over bytes.
class Hash {
public:
    void add(const void* data, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i)
            value_ = (value_ ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3ull;
    }
    template <class T>
    void add_all(const std::vector<T>& values) {
        const std::size_t size = values.size();
        add(&size, sizeof(size));
        if (size > 0) add(values.data(), size * sizeof(T));
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

inline std::uint64_t geometry_hash(const Scene& scene) {
    Hash hash;
    for (const Mesh& mesh : scene.meshes) {
        hash.add_all(mesh.positions);
        hash.add_all(mesh.normals);
        hash.add_all(mesh.tangents);
        hash.add_all(mesh.uv0);
        hash.add_all(mesh.colours);
        hash.add_all(mesh.indices);
    }
    return hash.value();
}

inline std::uint64_t image_hash(const Scene& scene) {
    Hash hash;
    for (const Image& image : scene.images)
        hash.add_all(image.texels);
    return hash.value();
}

inline std::uint64_t node_hash(const Scene& scene) {
    Hash hash;
    for (const Node& node : scene.nodes) {
        hash.add(node.name.data(), node.name.size());
        hash.add(&node.local.translation_m, sizeof(node.local.translation_m));
        hash.add(&node.local.rotation, sizeof(node.local.rotation));
        hash.add(&node.model, sizeof(node.model));
        hash.add(&node.light, sizeof(node.light));
    }
    return hash.value();
}

}  // namespace rambla::assets::test
