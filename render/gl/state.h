#pragma once

namespace rambla::render::gl {

/// Sets the state that every pass starts from: no depth test or write (compare: GL_GEQUAL, reversed Z), no
/// culling, counter-clockwise fronts, no blending, no scissor, all colour writes, encoding into sRGB
/// textures.
void reset_state();

}  // namespace rambla::render::gl
