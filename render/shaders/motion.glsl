// Where on the screen things were in the picture before. Included by vertex and fragment shaders.
#include "frame.glsl"
#include "render/shaders/shared/temporal.h"

layout(std140, binding = BINDING_PASS_UNIFORMS) uniform TemporalBlock {
    TemporalConstants temporal;
};

/// A motion that leads out of every picture: of what was behind the eye, where no pixel shows it.
const float k_nowhere_px = 30000.0;
/// What the target of motion vectors is cleared to: nothing there has moved by itself. A half float holds both.
const float k_at_rest = 60000.0;

bool is_at_rest(vec2 motion_px) {
    return motion_px.x > 0.5 * (k_nowhere_px + k_at_rest);
}

/// From a place in clip space to pixels from the lower left corner.
vec2 pixel_of(vec4 clip) {
    return (0.5 * clip.xy / clip.w + 0.5) * frame.size_px.xy;
}

/// By how many pixels what is seen at a place has moved since the picture before; both pictures without jitter.
/// @param place_px  of this picture as it is drawn
/// @param past      where that was then, clip space; anything, also behind the eye
vec2 motion_px(vec2 place_px, vec4 past) {
    const float least_w = 1e-6;  // a point that lies in the eye was seen nowhere
    if (!(past.w > least_w)) return vec2(k_nowhere_px);
    vec2 motion = place_px - temporal.jitter.xy - pixel_of(past);
    return clamp(motion, vec2(-k_nowhere_px), vec2(k_nowhere_px));
}
