#include "assets/import/gltf_skin.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "assets/import/gltf_accessor.h"

namespace rambla::assets::gltf {

namespace {

/// Exact, or not affine: the rounding of a product that someone stored.
constexpr float k_affine = 1e-3f;

bool all_finite(const glm::mat4& matrix) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(matrix[c][r])) return false;
    return true;
}

/// Writes the last row as it must be. @return  false when that changed more than rounding
bool make_affine(glm::mat4& matrix) {
    if (!all_finite(matrix)) {
        matrix = glm::mat4{1.0f};
        return false;
    }
    bool exact = true;
    for (int c = 0; c < 4; ++c) {
        const float wanted = c == 3 ? 1.0f : 0.0f;
        exact = exact && std::abs(matrix[c].w - wanted) <= k_affine;
        matrix[c].w = wanted;
    }
    return exact;
}

std::vector<glm::mat4> bind_matrices(const Document& document, int accessor, std::size_t joints,
                                     const std::string& element) {
    std::vector<glm::mat4> matrices(joints, glm::mat4{1.0f});
    if (accessor < 0) return matrices;
    const AccessorReader source{document, accessor, element};
    if (source.components() != 16 || !source.is_float())
        document.fail(element, std::to_string(source.components()) + " components", "16 floats");
    if (source.count() < joints)
        document.fail(element, std::to_string(source.count()) + " matrices",
                      std::to_string(joints) + ", one for each joint");
    const std::vector<float> numbers = source.read_floats(joints);
    for (std::size_t j = 0; j < joints; ++j)
        matrices[j] = glm::make_mat4(&numbers[16 * j]);
    const auto mended = std::count_if(matrices.begin(), matrices.end(),
                                      [](glm::mat4& matrix) { return !make_affine(matrix); });
    if (mended > 0)
        document.warn(element, std::to_string(mended) + " matrices were not affine and are mended");
    return matrices;
}

Skeleton import_skeleton(const Document& document, const tinygltf::Skin& source, const std::string& element) {
    const std::size_t nodes = document.model.nodes.size();
    Skeleton skeleton;
    skeleton.name = source.name;
    if (source.joints.empty()) document.warn(element + ".joints", "names no joint");
    for (std::size_t j = 0; j < source.joints.size(); ++j)
        skeleton.joints.push_back(
            document.checked(source.joints[j], nodes, element + element_name(".joints", j), "node"));
    if (source.skeleton >= 0)
        static_cast<void>(document.checked(source.skeleton, nodes, element + ".skeleton", "node"));
    skeleton.joint_from_mesh = bind_matrices(document, source.inverseBindMatrices, source.joints.size(),
                                             element + ".inverseBindMatrices");
    return skeleton;
}

/// Joints that the vertices of a mesh use: up to one below this number; 0 when it is not skinned.
std::uint32_t joints_needed(const Mesh& mesh) {
    std::uint32_t needed = 0;
    for (const glm::u16vec4& joints : mesh.joints)
        for (int i = 0; i < 4; ++i)
            needed = std::max(needed, joints[i] + 1u);
    return needed;
}

class SkinAssignment {
public:
    SkinAssignment(const Document& document, Scene& scene) : document_{document}, scene_{scene} {
        for (const Mesh& mesh : scene_.meshes)
            needed_.push_back(joints_needed(mesh));
    }

    void run(std::size_t index) {
        const tinygltf::Node& source = document_.model.nodes[index];
        if (source.skin < 0) return;
        const std::string element = element_name("nodes", index, ".skin");
        const std::uint32_t skin = document_.checked(source.skin, scene_.skeletons.size(), element, "skin");
        Node& node = scene_.nodes[index];
        const std::uint32_t needed = node.model == k_none ? 0 : joints_of(scene_.models[node.model]);
        const std::size_t joints = scene_.skeletons[skin].joints.size();
        if (needed == 0)
            document_.warn(element, "moves nothing: the node has no mesh with joints");
        else if (needed > joints)
            document_.fail(element,
                           "a mesh that follows joint " + std::to_string(needed - 1) + " of a skin with " +
                               std::to_string(joints) + " joints",
                           "joints of the skin");
        else
            node.skeleton = skin;
    }

private:
    std::uint32_t joints_of(const Model& model) const {
        std::uint32_t needed = 0;
        for (const ModelPart& part : model.parts)
            needed = std::max(needed, needed_[part.mesh]);
        return needed;
    }

    const Document& document_;
    Scene& scene_;
    std::vector<std::uint32_t> needed_;  ///< by mesh
};

}  // namespace

void import_skins(const Document& document, Scene& scene) {
    const std::vector<tinygltf::Skin>& skins = document.model.skins;
    for (std::size_t i = 0; i < skins.size(); ++i)
        scene.skeletons.push_back(import_skeleton(document, skins[i], element_name("skins", i)));
    SkinAssignment assignment{document, scene};
    for (std::size_t i = 0; i < document.model.nodes.size(); ++i)
        assignment.run(i);
}

}  // namespace rambla::assets::gltf
