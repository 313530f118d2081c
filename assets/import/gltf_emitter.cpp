#include "assets/import/gltf_emitter.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "assets/import/gltf_files.h"
#include "assets/import/gltf_value.h"

namespace rambla::assets::gltf {

namespace {

constexpr const char* k_list = "ramblaEmitters";
constexpr const char* k_of_node = "ramblaEmitter";

/// A member of an emitter, and what it may be: far more than any scene needs, and far less than what
/// overflows.
template <class T>
struct Member {
    const char* name;
    T Emitter::*member;
    float least;
    float most;
};
constexpr std::array<Member<float>, 5> k_numbers{
    {{"lifetime", &Emitter::lifetime_s, 0.0f, 1e4f},
     {"spread", &Emitter::spread_m, 0.0f, 1e3f},
     {"velocitySpread", &Emitter::velocity_spread_m_s, 0.0f, 1e3f},
     {"startRadius", &Emitter::start_radius_m, 1e-3f, 1e3f},
     {"endRadius", &Emitter::end_radius_m, 1e-3f, 1e3f}}};
constexpr std::array<Member<glm::vec3>, 2> k_vectors{
    {{"velocity", &Emitter::velocity_m_s, -1e3f, 1e3f},
     {"acceleration", &Emitter::acceleration_m_s2, -1e3f, 1e3f}}};

class EmitterImport {
public:
    EmitterImport(const Document& document, const tinygltf::Value& source, std::string element)
        : document_{document}, source_{source}, element_{std::move(element)} {}

    Emitter run(const Scene& scene) {
        if (source_.Has("name") && source_.Get("name").IsString())
            emitter_.name = source_.Get("name").Get<std::string>();
        for (const Member<float>& number : k_numbers)
            emitter_.*number.member = within(number.name, emitter_.*number.member, number.least, number.most);
        for (const Member<glm::vec3>& vector : k_vectors)
            read_vector(vector);
        const float count = within("count", 1.0f, 1.0f, static_cast<float>(k_max_particles));
        emitter_.count = static_cast<std::uint32_t>(count);
        if (static_cast<float>(emitter_.count) != count)
            document_.warn(element_ + ".count",
                           "is no whole number, " + std::to_string(emitter_.count) + " is used");
        read_material(scene);
        return std::move(emitter_);
    }

private:
    float within(const std::string& name, float fallback, float least, float most) {
        return source_.Has(name) ? within(source_.Get(name), name, fallback, least, most) : fallback;
    }

    float within(const tinygltf::Value& found, const std::string& name, float fallback, float least,
                 float most) {
        const float value = found.IsNumber() ? finite_float(found.GetNumberAsDouble()) : fallback;
        const float used = std::clamp(value, least, most);
        if (!found.IsNumber() || used != value)
            document_.warn(element_ + "." + name, "is no number from " + number_text(least) + " to " +
                                                      number_text(most) + ", " + number_text(used) +
                                                      " is used");
        return used;
    }

    void read_vector(const Member<glm::vec3>& vector) {
        if (!source_.Has(vector.name)) return;
        const tinygltf::Value& found = source_.Get(vector.name);
        if (!found.IsArray() || found.ArrayLen() != 3) {
            document_.warn(element_ + "." + vector.name, "is no array of 3 numbers, and is left out");
            return;
        }
        glm::vec3& to = emitter_.*vector.member;
        for (int axis = 0; axis < 3; ++axis)
            to[axis] = within(found.Get(axis), element_name(vector.name, static_cast<std::size_t>(axis)),
                              0.0f, vector.least, vector.most);
    }

    void read_material(const Scene& scene) {
        const int index = integer_of(source_, "material", -1);
        const bool exists = index >= 0 && static_cast<std::size_t>(index) < scene.materials.size();
        if (exists && scene.materials[static_cast<std::size_t>(index)].optical_depth > 0.0f) {
            emitter_.material = static_cast<std::uint32_t>(index);
            return;
        }
        document_.warn(element_ + ".material",
                       std::to_string(index) + " is no material with an optical depth: nothing is emitted");
    }

    const Document& document_;
    const tinygltf::Value& source_;
    std::string element_;
    Emitter emitter_;
};

}  // namespace

void import_emitters(const Document& document, Scene& scene) {
    const tinygltf::Value& extras = document.model.extras;
    if (!extras.IsObject() || !extras.Has(k_list)) return;
    const tinygltf::Value& list = extras.Get(k_list);
    const std::string name = std::string{"extras."}.append(k_list);
    if (!list.IsArray()) {
        document.warn(name, "is no array, and is left out");
        return;
    }
    for (int i = 0; i < static_cast<int>(list.ArrayLen()); ++i) {
        const std::string element = element_name(name, static_cast<std::size_t>(i));
        scene.emitters.push_back(EmitterImport{document, list.Get(i), element}.run(scene));
    }
}

std::uint32_t emitter_of(const Document& document, const Scene& scene, const tinygltf::Node& node,
                         const std::string& element) {
    if (!node.extras.IsObject() || !node.extras.Has(k_of_node)) return k_none;
    const int index = integer_of(node.extras, k_of_node, -1);
    if (index < 0 || static_cast<std::size_t>(index) >= scene.emitters.size()) {
        document.warn(
            std::string{element}.append(".extras.").append(k_of_node),
            "is no index of " + std::to_string(scene.emitters.size()) + " emitters, and is left out");
        return k_none;
    }
    const auto emitter = static_cast<std::uint32_t>(index);
    return scene.emitters[emitter].material == k_none ? k_none : emitter;
}

void spend_particles(Document& document, const Scene& scene) {
    constexpr std::uint64_t k_elements_per_particle = 64;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const std::uint32_t emitter = scene.nodes[i].emitter;
        if (emitter == k_none) continue;
        document.spend(element_name("nodes", i, std::string{".extras."}.append(k_of_node)),
                       k_elements_per_particle * scene.emitters[emitter].count);
    }
}

}  // namespace rambla::assets::gltf
