#include "assets/export/gltf_animation.h"

namespace rambla::assets {

namespace {

using Json = nlohmann::json;

const char* interpolation_name(Interpolation interpolation) {
    switch (interpolation) {
        case Interpolation::step:
            return "STEP";
        case Interpolation::cubic_spline:
            return "CUBICSPLINE";
        case Interpolation::linear:
            break;
    }
    return "LINEAR";
}

/// Components of one element of the accessor: weights are scalars, one after the other.
std::size_t components_of(const Channel& channel) {
    return channel.path == AnimatedPath::weights ? 1 : channel.width;
}

}  // namespace

Json GltfAnimation::skin_of(const Skeleton& skeleton) {
    const std::size_t matrices =
        buffer_.add(std::as_bytes(std::span{skeleton.joint_from_mesh}), skeleton.joint_from_mesh.size(),
                    {GltfBuffer::Component::f32, "MAT4"});
    Json out{{"joints", skeleton.joints}, {"inverseBindMatrices", matrices}};
    if (!skeleton.name.empty()) out["name"] = skeleton.name;
    return out;
}

Json GltfAnimation::animation_of(const Clip& clip, const std::vector<bool>& has_mesh) {
    Json out;
    for (const Channel& channel : clip.channels) {
        if (channel.path == AnimatedPath::weights && !has_mesh[channel.node]) continue;
        Json& samplers = out["samplers"];
        out["channels"].push_back({{"sampler", samplers.size()},
                                   {"target", {{"node", channel.node}, {"path", name_of(channel.path)}}}});
        samplers.push_back({{"input", add_times(channel.times_s)},
                            {"output", add_values(channel)},
                            {"interpolation", interpolation_name(channel.interpolation)}});
    }
    if (!out.is_null() && !clip.name.empty()) out["name"] = clip.name;
    return out;
}

std::size_t GltfAnimation::add_times(const std::vector<float>& times_s) {
    const auto [place, is_new] = times_.try_emplace(times_s, 0);
    if (is_new) {
        place->second = buffer_.add(std::as_bytes(std::span{times_s}), times_s.size(),
                                    {GltfBuffer::Component::f32, "SCALAR"});
        buffer_.set_range(place->second, Json::array({times_s.front()}), Json::array({times_s.back()}));
    }
    return place->second;
}

std::size_t GltfAnimation::add_values(const Channel& channel) {
    const std::size_t components = components_of(channel);
    const std::string type = components == 1 ? "SCALAR" : "VEC" + std::to_string(components);
    return buffer_.add(std::as_bytes(std::span{channel.values}), channel.values.size() / components,
                       {GltfBuffer::Component::f32, type});
}

}  // namespace rambla::assets
