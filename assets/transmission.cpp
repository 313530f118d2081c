#include "assets/transmission.h"

namespace rambla::assets {

namespace {

/// Of the light that a transmissive surface lets through, the part that replaces the surface itself.
constexpr float k_transmission_to_alpha = 0.9f;

}  // namespace

void blend_transmission(Scene& scene) {
    for (Material& material : scene.materials) {
        if (material.transmission <= 0.0f) continue;
        material.alpha_mode = AlphaMode::blend;
        material.base_colour.w *= 1.0f - k_transmission_to_alpha * material.transmission;
    }
}

}  // namespace rambla::assets
