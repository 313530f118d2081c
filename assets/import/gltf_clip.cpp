#include "assets/import/gltf_clip.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "assets/import/gltf_accessor.h"
#include "assets/import/gltf_files.h"
#include "assets/import/gltf_keys.h"

namespace rambla::assets::gltf {

namespace {

std::optional<AnimatedPath> path_of(const std::string& name) {
    if (name == "translation") return AnimatedPath::translation;
    if (name == "rotation") return AnimatedPath::rotation;
    if (name == "scale") return AnimatedPath::scale;
    if (name == "weights") return AnimatedPath::weights;
    return std::nullopt;
}

int components_of(AnimatedPath path) {
    switch (path) {
        case AnimatedPath::rotation:
            return 4;
        case AnimatedPath::weights:
            return 1;
        default:
            return 3;
    }
}

class ClipImport {
public:
    ClipImport(Document& document, const Scene& scene, std::size_t index)
        : document_{document},
          scene_{scene},
          source_{document.model.animations[index]},
          element_{element_name("animations", index)} {}

    Clip run() {
        clip_.name = source_.name;
        for (std::size_t c = 0; c < source_.channels.size(); ++c)
            read_channel(source_.channels[c], element_ + element_name(".channels", c));
        for (const Channel& channel : clip_.channels)
            clip_.duration_s = std::max(clip_.duration_s, channel.times_s.back());
        warn();
        return std::move(clip_);
    }

private:
    void read_channel(const tinygltf::AnimationChannel& source, const std::string& element) {
        const std::optional<AnimatedPath> path = path_of(source.target_path);
        if (source.target_node < 0 || !path) {
            ++without_target_;
            return;
        }
        Channel channel{.node = document_.checked(source.target_node, document_.model.nodes.size(),
                                                  element + ".target.node", "node"),
                        .path = *path,
                        .times_s = {},
                        .values = {}};
        const auto sampler =
            document_.checked(source.sampler, source_.samplers.size(), element + ".sampler", "sampler");
        const std::size_t targets = morph_targets(channel.node);
        if (*path == AnimatedPath::weights && targets == 0) {
            ++without_morphs_;
            return;
        }
        if (!taken_.emplace(channel.node, *path).second) {
            ++repeated_targets_;
            return;
        }
        channel.width =
            static_cast<std::uint32_t>(*path == AnimatedPath::weights ? targets : components_of(*path));
        read_keys(channel, source_.samplers[sampler], element_ + element_name(".samplers", sampler));
        keys_ += mend_keys(channel);
        if (channel.times_s.empty())
            ++without_keys_;
        else
            clip_.channels.push_back(std::move(channel));
    }

    std::size_t morph_targets(std::uint32_t node) const {
        const std::uint32_t model = scene_.nodes[node].model;
        return model == k_none ? 0 : scene_.models[model].morph_weights.size();
    }

    void read_keys(Channel& channel, const tinygltf::AnimationSampler& sampler, const std::string& element) {
        channel.interpolation = interpolation_of(sampler, element);
        const AccessorReader input{document_, sampler.input, element + ".input"};
        if (input.components() != 1 || !input.is_float())
            document_.fail(element + ".input",
                           std::to_string(input.components()) + " components of " +
                               (input.is_float() ? "float" : "an integer type"),
                           "float scalars");
        const AccessorReader output{document_, sampler.output, element + ".output"};
        const bool weights = channel.path == AnimatedPath::weights;
        if (output.components() != components_of(channel.path))
            document_.fail(element + ".output", std::to_string(output.components()) + " components",
                           std::to_string(components_of(channel.path)));
        const std::uint64_t per_key = (channel.interpolation == Interpolation::cubic_spline ? 3u : 1u) *
                                      (weights ? std::uint64_t{channel.width} : 1u);
        // Divided, not multiplied: neither number can be trusted.
        if (output.count() / per_key != input.count() || output.count() % per_key != 0)
            document_.fail(
                element + ".output", std::to_string(output.count()) + " elements",
                std::to_string(per_key) + " for each of " + std::to_string(input.count()) + " keys");
        document_.spend(element, input.count() + input.sparse_count());
        document_.spend(element, output.count() + output.sparse_count());
        document_.spend(element, output.count() * 3);  // up to four numbers each
        channel.times_s = input.read_floats(input.count());
        const bool unit = weights || channel.path == AnimatedPath::rotation;
        channel.values = output.read_floats(output.count(), unit);
    }

    Interpolation interpolation_of(const tinygltf::AnimationSampler& sampler,
                                   const std::string& element) const {
        if (sampler.interpolation == "STEP") return Interpolation::step;
        if (sampler.interpolation == "CUBICSPLINE") return Interpolation::cubic_spline;
        if (sampler.interpolation != "LINEAR" && !sampler.interpolation.empty())
            document_.fail(element + ".interpolation", in_quotes(sampler.interpolation),
                           "LINEAR, STEP or CUBICSPLINE");
        return Interpolation::linear;
    }

    void note(std::size_t count, const char* what) {
        if (count == 0) return;
        found_.append(found_.empty() ? "mended: " : ", ")
            .append(std::to_string(count))
            .append(" ")
            .append(what);
    }

    void warn() {
        note(keys_.repeated, "keys repeat the time before them");
        note(keys_.unsorted, "keys are out of order");
        note(keys_.unusable, "keys are no finite numbers from 0 on, and left out");
        note(keys_.not_unit, "rotations are not of unit length");
        note(without_target_, "channels without a node or a known path are left out");
        note(without_morphs_, "channels for nodes without morph targets are left out");
        note(repeated_targets_, "channels for what another one moves are left out");
        note(without_keys_, "channels without keys are left out");
        if (clip_.channels.empty()) found_.append(found_.empty() ? "moves nothing" : ", moves nothing");
        if (!found_.empty()) document_.warn(element_, found_);
    }

    Document& document_;
    const Scene& scene_;
    const tinygltf::Animation& source_;
    std::string element_;
    Clip clip_;
    KeyFindings keys_;
    std::size_t without_target_ = 0;
    std::size_t without_morphs_ = 0;
    std::size_t repeated_targets_ = 0;
    std::size_t without_keys_ = 0;
    std::set<std::pair<std::uint32_t, AnimatedPath>> taken_;
    std::string found_;
};

}  // namespace

void import_clips(Document& document, Scene& scene) {
    for (std::size_t i = 0; i < document.model.animations.size(); ++i)
        scene.clips.push_back(ClipImport{document, scene, i}.run());
}

}  // namespace rambla::assets::gltf
