#include "assets/import/gltf_instances.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "assets/import/gltf_accessor.h"
#include "assets/import/gltf_transform.h"
#include "assets/import/gltf_value.h"

namespace rambla::assets::gltf {

namespace {

constexpr const char* k_extension = "EXT_mesh_gpu_instancing";

/// What a node costs in the budget of vertices and indices, by its size in memory.
constexpr std::uint64_t k_elements_per_node = 16;

class InstanceImport {
public:
    InstanceImport(Document& document, const tinygltf::Value& extension, std::string element)
        : document_{document},
          attributes_{extension.Has("attributes") ? extension.Get("attributes") : extension},
          element_{std::move(element)} {}

    bool has_places() const {
        return attributes_.Has("TRANSLATION") || attributes_.Has("ROTATION") || attributes_.Has("SCALE");
    }

    std::vector<Transform> run() {
        const std::vector<float> translations = column("TRANSLATION", 3, false);
        const std::vector<float> rotations = column("ROTATION", 4, true);
        const std::vector<float> scales = column("SCALE", 3, false);
        std::vector<Transform> instances;
        std::size_t left_out = 0;
        for (std::uint64_t i = 0; i < count_.value_or(0); ++i) {
            Transform place;
            if (!translations.empty()) place.translation_m = three(translations, i);
            if (!scales.empty()) place.scale = three(scales, i);
            std::optional<glm::quat> rotation = place.rotation;
            if (!rotations.empty()) rotation = unit_rotation(glm::make_vec4(&rotations[4 * i]));
            if (!rotation || !is_finite(place.translation_m) || !is_finite(place.scale)) {
                ++left_out;
                continue;
            }
            place.rotation = *rotation;
            instances.push_back(place);
        }
        if (left_out > 0)
            document_.warn(element_,
                           std::to_string(left_out) + " instances have no finite place and are left out");
        return instances;
    }

private:
    std::vector<float> column(const char* name, int components, bool always_normalise) {
        if (!attributes_.Has(name)) return {};
        const std::string element = element_ + ".attributes." + name;
        const AccessorReader source{document_, integer_of(attributes_, name, -1), element};
        if (source.components() != components)
            document_.fail(element, std::to_string(source.components()) + " components",
                           std::to_string(components));
        if (count_ && source.count() != *count_)
            document_.fail(element, std::to_string(source.count()) + " elements",
                           std::to_string(*count_) + ", as the attributes before it have");
        if (!count_) document_.spend(element, source.count() * k_elements_per_node);
        count_ = source.count();
        document_.spend(element, source.sparse_count());
        return source.read_floats(source.count(), always_normalise);
    }

    static glm::vec3 three(const std::vector<float>& values, std::uint64_t at) {
        return {values[3 * at], values[3 * at + 1], values[3 * at + 2]};
    }
    static bool is_finite(glm::vec3 v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    }

    Document& document_;
    const tinygltf::Value& attributes_;
    std::string element_;
    std::optional<std::uint64_t> count_;
};

}  // namespace

void import_instances(Document& document, Scene& scene) {
    for (std::size_t i = 0; i < document.model.nodes.size(); ++i) {
        const tinygltf::Node& source = document.model.nodes[i];
        const auto extension = source.extensions.find(k_extension);
        if (extension == source.extensions.end()) continue;
        const std::string element = element_name("nodes", i, std::string{".extensions."} + k_extension);
        InstanceImport import{document, extension->second, element};
        if (scene.nodes[i].model == k_none || !import.has_places()) {
            document.warn(element, "repeats nothing: it needs a mesh and attributes");
            continue;
        }
        const Node repeated = scene.nodes[i];
        for (const Transform& place : import.run()) {
            Node instance;
            instance.parent = static_cast<std::uint32_t>(i);
            instance.local = place;
            instance.model = repeated.model;
            instance.skeleton = repeated.skeleton;
            instance.morph_weights = repeated.morph_weights;
            scene.nodes[i].children.push_back(static_cast<std::uint32_t>(scene.nodes.size()));
            scene.nodes.push_back(std::move(instance));
        }
        scene.nodes[i].model = k_none;
        scene.nodes[i].skeleton = k_none;
        scene.nodes[i].morph_weights.clear();
    }
}

}  // namespace rambla::assets::gltf
