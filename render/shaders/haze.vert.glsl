// A ball of haze as a quad before it that covers it on the screen: in a perspective the part of its nearest tangent
// plane that the cone around it cuts out. Where that comes too near to the eye, or the eye is inside, the quad is the
// screen.
#include "frame.glsl"
#include "scene_buffers.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 corner;  ///< (±1, ±1, 0)

#define VARYING out
#include "haze_varyings.glsl"

vec4 outside() {
    return vec4(2.0, 2.0, 2.0, 1.0);
}

vec4 whole_screen() {
    return vec4(corner.xy, 1.0, 1.0);  // at the near plane
}

vec4 clip_of(vec3 view) {
    return frame.clip_from_view * vec4(view, 1.0);
}

vec4 orthographic(vec3 centre, float radius) {
    vec4 near_side = clip_of(centre + vec3(0.0, 0.0, radius));
    if (clip_of(centre - vec3(0.0, 0.0, radius)).z > 1.0) return outside();
    vec4 at = clip_of(centre + vec3(corner.xy * radius, radius));
    at.z = min(near_side.z, 1.0);
    return at;
}

vec4 perspective(vec3 centre, float radius, float near_m) {
    if (radius - centre.z < near_m) return outside();
    float distance_m = length(centre);
    float tangent_m = distance_m - radius;
    if (tangent_m <= near_m) return whole_screen();
    vec3 ahead = centre / distance_m;
    vec3 least = abs(ahead.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    vec3 right = normalize(cross(ahead, least));
    vec3 up = cross(right, ahead);
    // tan asin(r/D) at the tangent plane's distance D − r, without squares of either.
    float half_size = radius * sqrt(tangent_m / (distance_m + radius));
    const float slack = 1.0 + 1e-4;
    half_size *= slack;
    float nearest_corner = -ahead.z * tangent_m - half_size * (abs(right.z) + abs(up.z));
    if (nearest_corner < near_m * slack) return whole_screen();
    return clip_of(ahead * tangent_m + (right * corner.x + up * corner.y) * half_size);
}

void main() {
    Instance instance = instances[gl_BaseInstanceARB + gl_InstanceID];
    vec3 centre = vec3(instance.row0.w, instance.row1.w, instance.row2.w);
    float radius = instance.row0.x;
    vec3 in_view = mat3(frame.view_from_world) * centre;
    bool is_orthographic = frame.counts.y != 0u;
    gl_Position = !(radius > 0.0) ? outside()
                  : is_orthographic ? orthographic(in_view, radius)
                                    : perspective(in_view, radius, frame.depth_scale.x);
    ball.centre_radius = vec4(centre, radius);
    ball.material = material_row(instance);
    ball.opacity = instance_opacity(instance);
}
