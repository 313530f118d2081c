#include "frame.glsl"

/// Towards the eye from a point that is seen; all the same way in an orthographic view. The eye itself looks
/// ahead.
vec3 direction_to_eye(vec3 position) {
    float length2 = dot(position, position);
    bool orthographic = frame.counts.y != 0u;
    return orthographic || length2 < 1e-20 ? frame.world_from_view[2].xyz : -position * inversesqrt(length2);
}
