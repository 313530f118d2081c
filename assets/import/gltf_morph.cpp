#include "assets/import/gltf_morph.h"

#include "assets/import/gltf_value.h"

namespace rambla::assets::gltf {

namespace {

class MorphImport {
public:
    MorphImport(VertexReader& reader, const tinygltf::Primitive& primitive, const Mesh& mesh)
        : reader_{reader}, primitive_{primitive}, mesh_{mesh} {}

    MorphTarget run(std::size_t index) {
        name_ = element_name("targets", index);
        attributes_ = &primitive_.targets[index];
        return {.name = {},
                .positions = column("POSITION", true),
                .normals = column("NORMAL", !mesh_.normals.empty()),
                .tangents = column("TANGENT", !mesh_.tangents.empty())};
    }

private:
    std::vector<glm::vec3> column(const char* what, bool mesh_has_it) {
        const int accessor = attribute(*attributes_, what);
        if (accessor < 0) return {};
        const std::string name = name_ + "." + what;
        const std::string element = reader_.element() + "." + name;
        if (!mesh_has_it && attribute(primitive_.attributes, what) < 0)
            reader_.document().warn(element, std::string{"moves what the primitive lacks: there is no "} +
                                                 what + " to move, the target is left out");
        if (!mesh_has_it) return {};
        reader_.document().spend(element, reader_.size());
        return reader_.read<3>(accessor, name);
    }

    VertexReader& reader_;
    const tinygltf::Primitive& primitive_;
    const Mesh& mesh_;
    std::string name_;
    const Attributes* attributes_ = nullptr;
};

}  // namespace

void read_morphs(VertexReader& reader, const tinygltf::Primitive& primitive, Mesh& mesh) {
    MorphImport import{reader, primitive, mesh};
    for (std::size_t i = 0; i < primitive.targets.size(); ++i)
        mesh.morphs.push_back(import.run(i));
}

std::size_t morph_count(const Document& document, const tinygltf::Mesh& mesh, const std::string& element) {
    if (mesh.primitives.empty()) return 0;
    const std::size_t count = mesh.primitives[0].targets.size();
    for (std::size_t p = 1; p < mesh.primitives.size(); ++p)
        if (mesh.primitives[p].targets.size() != count)
            document.fail(element + element_name(".primitives", p, ".targets"),
                          std::to_string(mesh.primitives[p].targets.size()) + " morph targets",
                          std::to_string(count) + ", as primitives[0] has");
    return count;
}

std::string morph_name(const tinygltf::Mesh& mesh, std::size_t target) {
    if (!mesh.extras.Has("targetNames")) return {};
    const tinygltf::Value& names = mesh.extras.Get("targetNames");
    if (target >= names.ArrayLen()) return {};
    const tinygltf::Value& name = names.Get(static_cast<int>(target));
    return name.IsString() ? name.Get<std::string>() : std::string{};
}

std::vector<float> morph_weights(const Document& document, const std::vector<double>& given,
                                 std::size_t targets, const std::string& element) {
    if (!given.empty() && given.size() != targets)
        document.warn(element, std::to_string(given.size()) + " weights for " + std::to_string(targets) +
                                   " morph targets: surplus ones are left out, missing ones are 0");
    std::vector<float> weights(targets, 0.0f);
    for (std::size_t i = 0; i < std::min(targets, given.size()); ++i)
        weights[i] = finite_float(given[i]);
    return weights;
}

}  // namespace rambla::assets::gltf
