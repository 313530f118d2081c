#include "assets/cache/cached_process.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <string_view>
#include <vector>

#include "assets/cache/processed_payload.h"
#include "assets/mesh_columns.h"
#include "assets/texture_levels.h"

namespace rambla::assets {

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// What results are made of.

/// A hasher that begins with the kind of result and the code's version.
void begin(ContentHasher& hasher, std::string_view kind) {
    hasher.add(kind);
    hasher.add(k_processing_version);
}

template <class Struct, class Table>
void add(ContentHasher& hasher, const Struct& parameters, const Table& table) {
    for (const Parameter<Struct>& parameter : table)
        hasher.add(parameter.get(parameters));
}

ContentHash key_of(const Mesh& mesh, MeshUse use, const ProcessParameters& parameters) {
    ContentHasher hasher;
    begin(hasher, "mesh");
    hasher.add(mesh.name);
    hasher.add(mesh.topology);
    hasher.add(mesh.morphs.size());
    for (const MorphTarget& morph : mesh.morphs)
        hasher.add(morph.name);
    for_each_column(mesh, [&](const auto& column) { hasher.add(std::span{column}); });
    hasher.add(std::span{mesh.indices});
    hasher.add(use.meets_others);
    hasher.add(use.see_through);
    add(hasher, parameters.meshes, k_mesh_parameters);
    add(hasher, parameters.lods, k_lod_parameters);
    add(hasher, parameters.occluders, k_occluder_parameters);
    return hasher.hash();
}

ContentHash hash_of(const Image& image) {
    ContentHasher hasher;
    hasher.add(image.name);
    hasher.add(image.width);
    hasher.add(image.height);
    hasher.add(image.format);
    hasher.add(std::span{image.texels});
    return hasher.hash();
}

ContentHash key_of(const TextureJob& job, ChannelMask channels, std::span<const ContentHash> images,
                   const TextureParameters& parameters) {
    ContentHasher hasher;
    begin(hasher, "texture");
    for (const std::uint32_t image : {job.image, job.normals})
        hasher.add(image == k_none ? ContentHash{} : images[image]);
    hasher.add(job.role);
    hasher.add(job.colour_space);
    hasher.add(job.alpha);
    hasher.add(job.cutoff);
    hasher.add(job.roughness);
    hasher.add(job.normal_scale);
    hasher.add(channels);
    add(hasher, parameters, k_texture_parameters);
    return hasher.hash();
}

// What is read may be sound and yet not be what was asked for: hashes can be forged.

std::uint32_t largest_joint(const Mesh& mesh) {
    std::uint16_t largest = 0;
    for (const glm::u16vec4 joints : mesh.joints)
        largest = std::max({largest, joints.x, joints.y, joints.z, joints.w});
    return largest;
}

std::vector<bool> columns_present(const Mesh& mesh) {
    std::vector<bool> present;
    for_each_column(mesh, [&](const auto& column) { present.push_back(!column.empty()); });
    return present;
}

/// Whether models, skeletons and materials of the scene can be used with what was read as with `source`.
bool stands_for(const Mesh& source, const Mesh& read) {
    if (read.topology != source.topology || read.morphs.size() != source.morphs.size()) return false;
    // Vertices that nothing refers to go when a mesh is processed.
    if (read.indices.empty() || source.indices.empty()) return read.indices.size() == source.indices.size();
    return columns_present(read) == columns_present(source) && largest_joint(read) <= largest_joint(source);
}

/// One mesh or texture each: textures first, as they take longest to make.
class Run {
public:
    Run(const Scene& scene, const ProcessParameters& parameters, Cache& cache, KeptLevels kept)
        : scene_{scene},
          parameters_{parameters},
          cache_{cache},
          kept_{kept},
          uses_{mesh_uses(scene)},
          plan_{plan_textures(scene)},
          keys_(plan_.jobs.size() + scene.meshes.size()),
          found_(keys_.size()) {
        out_.scene.images.resize(plan_.jobs.size());
        out_.scene.meshes.resize(scene.meshes.size());
    }

    CachedProcess operator()(const ProcessProgress& progress) {
        const Clock::time_point start = Clock::now();
        hash_all();
        tbb::parallel_for(std::size_t{0}, keys_.size(), [this](std::size_t i) { found_[i] = load(i); });
        out_.loading_ms = ms_since(start);

        const Clock::time_point made_from = Clock::now();
        std::vector<std::size_t> missing;
        for (std::size_t i = 0; i < found_.size(); ++i)
            if (found_[i] == 0) missing.push_back(i);
        std::mutex mutex;
        std::uint32_t made = 0;
        tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
            make(missing[i]);
            const std::lock_guard lock{mutex};
            ++made;
            if (progress) progress(made, static_cast<std::uint32_t>(missing.size()));
        });
        find_entries();
        out_.processing_ms = ms_since(made_from);

        out_.processed = static_cast<std::uint32_t>(missing.size());
        out_.loaded = static_cast<std::uint32_t>(keys_.size() - missing.size());
        out_.scene.materials = std::move(plan_.materials);
        out_.scene.textures = std::move(plan_.textures);
        return std::move(out_);
    }

private:
    [[nodiscard]] bool is_texture(std::size_t i) const { return i < plan_.jobs.size(); }
    [[nodiscard]] std::size_t mesh_of(std::size_t i) const { return i - plan_.jobs.size(); }

    void hash_all() {
        std::vector<ContentHash> images(scene_.images.size());
        tbb::parallel_for(std::size_t{0}, images.size(),
                          [&](std::size_t i) { images[i] = hash_of(scene_.images[i]); });
        tbb::parallel_for(std::size_t{0}, keys_.size(), [&](std::size_t i) {
            keys_[i] = is_texture(i) ? key_of(plan_.jobs[i], plan_.channels[i], images, parameters_.textures)
                                     : key_of(scene_.meshes[mesh_of(i)], uses_[mesh_of(i)], parameters_);
        });
    }

    [[nodiscard]] bool load(std::size_t i) {
        const std::optional<std::vector<std::byte>> payload = cache_.load(keys_[i]);
        if (!payload) return false;
        if (is_texture(i)) {
            std::optional<TextureData> texture = texture_from_payload(*payload);
            if (!texture) return false;
            drop_fine_levels(*texture);  // at once: all textures of a scene need not fit side by side
            out_.scene.images[i] = std::move(*texture);
            return true;
        }
        std::optional<ProcessedMesh> mesh = mesh_from_payload(*payload);
        if (!mesh || !stands_for(scene_.meshes[mesh_of(i)], mesh->mesh)) return false;
        out_.scene.meshes[mesh_of(i)] = std::move(*mesh);
        return true;
    }

    void make(std::size_t i) {
        if (is_texture(i)) {
            TextureData& texture = out_.scene.images[i];
            texture = make_texture(i);
            found_[i] = cache_.store(keys_[i], to_payload(texture)) ? 1 : 0;
        } else {
            ProcessedMesh& mesh = out_.scene.meshes[mesh_of(i)];
            mesh = process_mesh(scene_.meshes[mesh_of(i)], uses_[mesh_of(i)], parameters_);
            cache_.store(keys_[i], to_payload(mesh));
        }
    }

    void drop_fine_levels(TextureData& texture) const {
        if (kept_ == KeptLevels::floors) drop_levels(texture, floor_level(texture));
    }

    /// Storing an entry may have thrown out others of the same scene, if its limit is tight: what they held
    /// must be here.
    void find_entries() {
        out_.texture_entries.resize(out_.scene.images.size());
        tbb::parallel_for(std::size_t{0}, out_.scene.images.size(), [this](std::size_t i) {
            TextureData& texture = out_.scene.images[i];
            if (found_[i] != 0 && cache_.contains(keys_[i])) {
                out_.texture_entries[i] = keys_[i];
                drop_fine_levels(texture);
            } else if (texture.first_stored > 0) {
                texture = make_texture(i);
            }
        });
    }

    [[nodiscard]] TextureData make_texture(std::size_t i) const {
        return process_texture(plan_.jobs[i], plan_.channels[i], scene_.images, parameters_.textures);
    }

    const Scene& scene_;
    const ProcessParameters& parameters_;
    Cache& cache_;
    KeptLevels kept_;
    std::vector<MeshUse> uses_;
    TexturePlan plan_;
    std::vector<ContentHash> keys_;
    std::vector<char> found_;  ///< or stored; not bools, which threads cannot write side by side
    CachedProcess out_;
};

}  // namespace

CachedProcess process_cached(const Scene& scene, const ProcessParameters& parameters, Cache& cache,
                             const ProcessProgress& progress, KeptLevels kept) {
    return Run{scene, parameters, cache, kept}(progress);
}

}  // namespace rambla::assets
