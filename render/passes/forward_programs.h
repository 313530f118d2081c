#pragma once

#include <array>
#include <cstdint>

#include "render/gl/program.h"
#include "render/passes/surface_detail.h"
#include "render/settings.h"

namespace rambla::render {

/// The programs that light surfaces as they are drawn, made when they are first asked for.
class ForwardPrograms {
public:
    struct Variant {
        bool blended = false;
        bool masked = false;
        SurfaceDetail detail = SurfaceDetail::colour;
        bool emissive = false;
        bool skinned = false;
        bool morphed = false;
        bool shadowed = false;
        bool wide_filter = false;
        bool specular = false;
        bool transmissive = false;
        bool light_mapped = false;
        Brdf brdf = Brdf::ggx;
    };

    explicit ForwardPrograms(gl::ProgramRegistry& programs) : programs_{programs} {}

    [[nodiscard]] const gl::Program& get(Variant variant);

private:
    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, std::size_t{1024} * k_surface_details * k_brdf_models.size()> variants_{};
};

}  // namespace rambla::render
