#include "assets/import/gltf_lod.h"

#include "assets/import/gltf_value.h"

namespace rambla::assets::gltf {

namespace {

constexpr const char* k_extension = "MSFT_lod";

class LevelImport {
public:
    LevelImport(const Document& document, Scene& scene)
        : document_{document}, scene_{scene}, is_level_(scene.nodes.size(), false), is_root_(is_level_) {
        for (const std::uint32_t root : scene.roots)
            is_root_[root] = true;
    }

    std::vector<bool> run() {
        for (std::size_t i = 0; i < scene_.nodes.size(); ++i)
            if (document_.model.nodes[i].extensions.contains(k_extension)) read(i);
        return std::move(is_level_);
    }

private:
    void read(std::size_t index) {
        const tinygltf::Node& source = document_.model.nodes[index];
        const std::string element = element_name("nodes", index, ".extensions.MSFT_lod");
        const std::vector<std::uint32_t> levels = levels_of(source, element);
        for (std::size_t l = 0; l < levels.size(); ++l) {
            const std::uint32_t level = levels[l];
            if (level != index && is_free(level)) {
                is_level_[level] = true;
                continue;
            }
            for (std::size_t taken = 0; taken < l; ++taken)
                is_level_[levels[taken]] = false;
            document_.warn(element, "levels of detail are left out: node " + std::to_string(level) +
                                        " is no node of its own, apart from the scene");
            return;
        }
        scene_.nodes[index].coarser = levels;
        scene_.nodes[index].screen_coverage = coverage_of(source, levels.size() + 1);
    }

    std::vector<std::uint32_t> levels_of(const tinygltf::Node& source, const std::string& element) const {
        const tinygltf::Value& ids = source.extensions.at(k_extension).Get("ids");
        std::vector<std::uint32_t> levels;
        for (std::size_t l = 0; l < ids.ArrayLen(); ++l) {
            const tinygltf::Value& id = ids.Get(static_cast<int>(l));
            levels.push_back(document_.checked(id.IsInt() ? id.GetNumberAsInt() : -1, scene_.nodes.size(),
                                               element + element_name(".ids", l), "node"));
        }
        return levels;
    }

    bool is_free(std::uint32_t node) const {
        return !is_level_[node] && !is_root_[node] && scene_.nodes[node].parent == k_none;
    }

    /// Exporters write it beside the extension; nothing, unless it has one number for each level.
    static std::vector<float> coverage_of(const tinygltf::Node& source, std::size_t levels) {
        std::vector<float> coverage;
        if (!source.extras.Has("MSFT_screencoverage")) return coverage;
        const tinygltf::Value& shares = source.extras.Get("MSFT_screencoverage");
        if (shares.ArrayLen() != levels) return coverage;
        for (std::size_t l = 0; l < levels; ++l) {
            const tinygltf::Value& share = shares.Get(static_cast<int>(l));
            if (!share.IsNumber()) return {};
            coverage.push_back(unit_interval(share.GetNumberAsDouble()));
        }
        return coverage;
    }

    const Document& document_;
    Scene& scene_;
    std::vector<bool> is_level_;
    std::vector<bool> is_root_;
};

}  // namespace

std::vector<bool> import_levels(const Document& document, Scene& scene) {
    return LevelImport{document, scene}.run();
}

}  // namespace rambla::assets::gltf
