#include "render/passes/forward_programs.h"

#include <string>

namespace rambla::render {
namespace {

const char* flag(bool on) {
    return on ? "1" : "0";
}

}  // namespace

const gl::Program& ForwardPrograms::get(Variant v) {
    const std::size_t choices =
        static_cast<std::size_t>(v.brdf) * k_surface_details + static_cast<std::size_t>(v.detail);
    const std::size_t index = (v.blended ? 1u : 0u) | (v.masked ? 2u : 0u) | (v.emissive ? 4u : 0u) |
                              (v.skinned ? 8u : 0u) | (v.morphed ? 16u : 0u) | (v.shadowed ? 32u : 0u) |
                              (v.wide_filter ? 64u : 0u) | (v.specular ? 128u : 0u) |
                              (v.transmissive ? 256u : 0u) | (v.light_mapped ? 512u : 0u) | choices << 10u;
    if (variants_[index] == nullptr) {
        variants_[index] = &programs_.get({.name = v.blended ? "blend" : "forward",
                                           .vertex = "mesh.vert.glsl",
                                           .fragment = "forward.frag.glsl",
                                           .compute = {},
                                           .defines = {{"BLENDED", flag(v.blended)},
                                                       {"ALPHA_MASK", flag(v.masked)},
                                                       {"DETAIL", detail_define(v.detail)},
                                                       {"EMISSION", flag(v.emissive)},
                                                       {"SPECULAR", flag(v.specular)},
                                                       {"TRANSMISSION", flag(v.transmissive)},
                                                       {"LIGHT_MAP", flag(v.light_mapped)},
                                                       {"SKINNED", flag(v.skinned)},
                                                       {"MORPHED", flag(v.morphed)},
                                                       {"SHADOW_MAP", flag(v.shadowed)},
                                                       {"TAPS", v.wide_filter ? "16" : "4"},
                                                       {"LOCAL_LIGHTS", "LOCAL_LIGHTS_CELL"},
                                                       {"BRDF", std::to_string(static_cast<int>(v.brdf))}}});
    }
    return *variants_[index];
}

}  // namespace rambla::render
