#include "support/scene_check.h"

#include <algorithm>
#include <cmath>

#include "assets/mesh_columns.h"

namespace rambla::assets::test {

namespace {

/// Collects the first problem only.
class Check {
public:
    explicit Check(const Scene& scene) : scene_{scene} {}

    std::string run() {
        for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
            where_ = "meshes[" + std::to_string(i) + "]";
            check(scene_.meshes[i]);
        }
        for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
            where_ = "nodes[" + std::to_string(i) + "]";
            check(scene_.nodes[i], i);
        }
        for (std::size_t i = 0; i < scene_.clips.size(); ++i) {
            where_ = "clips[" + std::to_string(i) + "]";
            check(scene_.clips[i]);
        }
        where_ = "scene";
        check_references();
        return problem_;
    }

private:
    void expect(bool holds, const char* what) {
        if (!holds && problem_.empty()) problem_ = where_ + ": " + what;
    }
    template <class T>
    void expect_index(std::uint32_t index, const std::vector<T>& array, const char* what) {
        expect(index == k_none || index < array.size(), what);
    }

    void check(const Mesh& mesh) {
        const std::size_t n = mesh.positions.size();
        for (const std::uint32_t index : mesh.indices)
            expect(index < n, "an index beyond the vertices");
        for_each_column(mesh, [&](const auto& column) {
            expect(column.empty() || column.size() == n, "a column of another length than the positions");
        });
        for (const glm::vec3& p : mesh.positions)
            expect(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
                   "a position that is not finite");
        // Computed and given directions alike; this is what files store.
        constexpr float k_unit = 1e-3f;
        for (const glm::vec3& normal : mesh.normals)
            expect(std::abs(glm::length(normal) - 1.0f) <= k_unit, "a normal that is not of unit length");
        for (const glm::vec4& tangent : mesh.tangents)
            expect(std::abs(glm::length(glm::vec3{tangent}) - 1.0f) <= k_unit && std::abs(tangent.w) == 1.0f,
                   "a tangent that is not of unit length");
        constexpr float k_four_roundings = 1e-5f;
        for (const glm::vec4& w : mesh.weights) {
            expect(w.x >= w.y && w.y >= w.z && w.z >= w.w && w.w >= 0.0f, "weights that do not fall");
            expect(std::abs(w.x + w.y + w.z + w.w - 1.0f) <= k_four_roundings,
                   "weights of another sum than 1");
        }
    }

    void check(const Node& node, std::size_t index) {
        expect_index(node.parent, scene_.nodes, "a parent that does not exist");
        expect_index(node.model, scene_.models, "a model that does not exist");
        expect_index(node.camera, scene_.cameras, "a camera that does not exist");
        expect_index(node.light, scene_.lights, "a light that does not exist");
        expect_index(node.skeleton, scene_.skeletons, "a skeleton that does not exist");
        for (const std::uint32_t level : node.coarser)
            expect(level < scene_.nodes.size(), "a level of detail that does not exist");
        for (const std::uint32_t child : node.children)
            expect(child < scene_.nodes.size() && scene_.nodes[child].parent == index,
                   "a child that does not know its parent");
        const Transform& local = node.local;
        for (int c = 0; c < 3; ++c)
            expect(std::isfinite(local.translation_m[c]) && std::isfinite(local.scale[c]),
                   "a transform that is not finite");
        // A rotation by k_rotation more would scale a model of a kilometre by less than a metre.
        constexpr float k_rotation = 1e-3f;
        expect(std::abs(glm::length(local.rotation) - 1.0f) <= k_rotation,
               "a rotation that is not of unit length");
    }

    void check(const Clip& clip) {
        for (const Channel& channel : clip.channels) {
            const std::size_t per_key =
                channel.width * (channel.interpolation == Interpolation::cubic_spline ? 3u : 1u);
            const std::vector<float>& times = channel.times_s;
            expect(channel.node < scene_.nodes.size(), "a channel of no node");
            expect(channel.values.size() == times.size() * per_key,
                   "another number of values than keys ask for");
            expect(std::all_of(channel.values.begin(), channel.values.end(),
                               [](float value) { return std::isfinite(value); }),
                   "a value that is not finite");
            if (times.empty()) return expect(false, "a channel without keys");
            expect(times.front() >= 0.0f && times.back() <= clip.duration_s, "a key outside of the clip");
            expect(std::adjacent_find(times.begin(), times.end(), std::greater_equal<>{}) == times.end(),
                   "keys out of order");
        }
    }

    void check_references() {
        for (const Model& model : scene_.models)
            for (const ModelPart& part : model.parts) {
                expect(part.mesh < scene_.meshes.size(), "a model of a mesh that does not exist");
                expect_index(part.material, scene_.materials, "a model of a material that does not exist");
            }
        for (const Material& material : scene_.materials)
            for_each_texture_slot(material, [&](const TextureSlot& slot) {
                expect_index(slot.texture, scene_.textures, "a material with a texture that does not exist");
                expect(slot.uv_set <= 1, "a third set of texture coordinates");
            });
        for (const Texture& texture : scene_.textures)
            expect(texture.image < scene_.images.size(), "a texture without an image");
        for (const Image& image : scene_.images)
            expect(image.texels.size() ==
                       std::size_t{image.width} * image.height * bytes_per_texel(image.format),
                   "an image of another size than it says");
        for (const Skeleton& skeleton : scene_.skeletons) {
            expect(skeleton.joint_from_mesh.size() == skeleton.joints.size(), "joints without a matrix");
            for (const std::uint32_t joint : skeleton.joints)
                expect(joint < scene_.nodes.size(), "a joint that does not exist");
        }
        for (const std::uint32_t root : scene_.roots)
            expect(root < scene_.nodes.size(), "a root that does not exist");
    }

    const Scene& scene_;
    std::string where_;
    std::string problem_;
};

}  // namespace

std::string problem_of(const Scene& scene) {
    return Check{scene}.run();
}

}  // namespace rambla::assets::test
