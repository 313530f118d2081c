// A quad about each of the frame's lights that is seen, as a strip of vertices 0…3; as large as the angle up to which
// its corona is drawn. How much of the lamp is seen is found here, by a few looks at the depths about its middle.
#include "frame.glsl"
#include "unproject.glsl"
#include "lights.glsl"
#include "corona.glsl"
#include "render/shaders/shared/light.h"

layout(binding = UNIT_PASS) uniform sampler2D depth_target;
layout(std430, binding = BINDING_LIGHTS) readonly buffer LightBlock {
    Light lights[];
};

layout(std140, binding = BINDING_PASS_UNIFORMS) uniform ShownViewBlock {
    mat4 shown_clip_from_view;  ///< as the picture is shown; depths are those of the view that was drawn
};

out vec2 place_deg;           ///< from the lamp's middle
flat out vec3 illuminance;    ///< at the eye, pre-exposed, of what is seen of the lamp
flat out float lamp_deg;      ///< how large half the lamp is seen

/// What lamps are like: this far about their middle their own glass and iron may lie before it.
const float k_lamp_radius_m = 0.25;
/// What shines in it is this large.
const float k_flame_radius_m = 0.06;
/// Nearer lamps are seen as what they are.
const float k_nearest_m = 0.5;
/// Illuminance whose corona is not seen: a 2048th of display white, a degree from the lamp.
const float k_least_illuminance = 1.0 / 2048.0 / (9.4 * k_needle_share);
const int k_looks_along_edge = 4;

/// @return  share of the looks, spread over the lamp's square, at which nothing is before it
float share_seen(vec3 lamp_m) {
    float seen = 0.0;
    for (int i = 0; i < k_looks_along_edge * k_looks_along_edge; ++i) {
        vec2 side = (vec2(i % k_looks_along_edge, i / k_looks_along_edge) + 0.5) / float(k_looks_along_edge) - 0.5;
        vec4 clip = frame.clip_from_view * vec4(lamp_m + vec3(side * k_lamp_radius_m, 0.0), 1.0);
        vec2 uv = 0.5 * clip.xy / clip.w + 0.5;
        if (any(lessThan(uv, vec2(0.0))) || any(greaterThanEqual(uv, vec2(1.0)))) continue;
        float depth = texelFetch(depth_target, ivec2(uv * frame.size_px.xy), 0).x;
        bool is_free = depth == 0.0 || frame.depth_scale.x / depth > -lamp_m.z - k_lamp_radius_m;
        seen += is_free ? 1.0 : 0.0;
    }
    return seen / float(k_looks_along_edge * k_looks_along_edge);
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside, until something is seen
    place_deg = vec2(0.0);
    illuminance = vec3(0.0);
    lamp_deg = 0.0;
    Light light = lights[gl_InstanceID];
    vec3 lamp_m = mat3(frame.view_from_world) * light.position_radius.xyz;
    float distance_m = length(lamp_m);
    if (!(distance_m > k_nearest_m) || !(-lamp_m.z > k_nearest_m)) return;
    vec3 to_eye = -light.position_radius.xyz / distance_m;
    float cone = cone_attenuation(dot(to_eye, light.direction_cos_inner.xyz), light.direction_cos_inner.w,
                                  light.intensity_cos_outer.w);
    vec3 arriving = light.intensity_cos_outer.xyz * (cone * frame.exposure.x / (distance_m * distance_m));
    if (!(max(arriving.r, max(arriving.g, arriving.b)) > k_least_illuminance)) return;
    illuminance = arriving * share_seen(lamp_m);
    if (!(max(illuminance.r, max(illuminance.g, illuminance.b)) > k_least_illuminance)) return;
    lamp_deg = degrees(atan(k_flame_radius_m, distance_m));
    vec2 side = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    place_deg = side * k_corona_deg;
    vec3 ahead = lamp_m / distance_m;
    vec3 right = normalize(cross(ahead, vec3(0.0, 1.0, 0.0)) + vec3(1e-6, 0.0, 0.0));
    vec3 up = cross(right, ahead);
    float half_size_m = distance_m * tan(radians(k_corona_deg));
    vec4 clip = shown_clip_from_view * vec4(lamp_m + half_size_m * (side.x * right + side.y * up), 1.0);
    gl_Position = vec4(clip.xy, 0.0, clip.w);
}
