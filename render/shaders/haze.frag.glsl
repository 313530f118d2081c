// A ball of haze over the lit picture, by how much of it lies before what the pixel shows: a depth impostor. It is lit
// like a surface that faces outwards where the look enters it, without highlights. The alpha of its base colour, whatever
// the alpha mode, says how much it scatters and hides; what it emits comes on top, so that alpha 0 is a glow before
// which nothing vanishes. Defines: LIT (0: it scatters nothing, or is unlit), SHADOW_MAP, TAPS, LOCAL_LIGHTS, BRDF.
#include "frame.glsl"
#include "scene_buffers.glsl"
#include "gbuffer_layout.glsl"
#include "unproject.glsl"
#if LIT
#include "sun_and_sky.glsl"
#include "local_lights.glsl"
#include "sun_reaches.glsl"
#endif
#include "haze.glsl"

#define VARYING in
#include "haze_varyings.glsl"

layout(binding = UNIT_BESIDE_MATERIALS + 1) uniform sampler2D depth_target;

layout(location = 0, index = 0) out vec4 out_radiance;
layout(location = 0, index = 1) out vec4 out_passes;  ///< share of what lies behind

struct Look {
    vec3 origin;     ///< camera-relative world
    vec3 direction;  ///< unit length
    Stretch clear;   ///< from the near plane to what the pixel shows
};

Look look_of_pixel() {
    vec2 uv = gl_FragCoord.xy * frame.size_px.zw;
    float depth = texelFetch(depth_target, ivec2(gl_FragCoord.xy), 0).x;
    mat3 to_world = mat3(frame.world_from_view);
    const float endless_m = 1e30;
    if (frame.counts.y != 0u) {
        vec3 near = view_position(uv, 1.0, frame.unprojection, frame.depth_scale);
        float far_m = near.z - view_position(uv, depth, frame.unprojection, frame.depth_scale).z;
        return Look(to_world * near, -to_world[2], Stretch(0.0, depth > 0.0 ? far_m : endless_m));
    }
    vec3 ray = view_ray(uv, frame.unprojection, frame.depth_scale);
    float near_m = frame.depth_scale.x / -ray.z;
    return Look(vec3(0.0), to_world * ray, Stretch(near_m, depth > 0.0 ? near_m / depth : endless_m));
}

#if LIT
vec3 light_on(Material m, vec3 normal, vec3 position, vec3 to_eye) {
    Surface s = Surface(normal, m.base_colour.rgb, vec3(0.0), 0.0, 1.0, 1.0);
    float distance_m = dot(position, -frame.world_from_view[2].xyz);
    return sky_light(s, to_eye) + sun_light(s, to_eye, sun_reaches(position, normal)) +
           directional_lights(s, to_eye) + local_lights(s, position, to_eye, distance_m);
}

/// Radiance that all of the haze sends towards the eye, were it opaque.
vec3 scattered(Material m, vec3 centre, float radius, Look look) {
    float begin = haze_entry(centre, radius, look.direction, look.clear.near);
    vec3 entry = begin * look.direction;
    vec3 outwards = (entry - centre) / radius;
    vec3 position = entry + look.origin;
    vec3 to_eye = -look.direction;
    // haze_entry() hands its last argument back as it is, unless the look enters the ball farther on.
    bool begins_inside = begin == look.clear.near;
    // Within the ball there is ever less of a side that faces outwards, and none in its middle, where the direction
    // outwards turns from one pixel to the next. On the rim there is nothing else, however far rounding moves the entry.
    float off_middle = length(outwards);
    float sided = begins_inside ? min(off_middle, 1.0) : 1.0;
    const float least_off_middle = 1e-6;  // nearer than roundings of a unit length, no direction is left
    vec3 normal = off_middle > least_off_middle ? outwards / off_middle : to_eye;
    vec3 light = sided * light_on(m, normal, position, to_eye);
    if (begins_inside) light += (1.0 - sided) * light_on(m, to_eye, position, to_eye);
    return light;
}
#else
vec3 scattered(Material m, vec3 centre, float radius, Look look) {
    bool unlit = (m.flags & k_material_unlit) != 0u;
    return unlit ? m.base_colour.rgb : vec3(0.0);
}
#endif

void main() {
    Material m = materials[ball.material];
    Look look = look_of_pixel();
    vec3 centre = ball.centre_radius.xyz - look.origin;
    float radius = ball.centre_radius.w;
    float thickness = m.transmission.z * haze_share(centre, radius, look.direction, look.clear);
    float cover = ball.opacity * (1.0 - exp(-thickness));
    if (!(cover > 0.0)) discard;

    float alpha = clamp(m.base_colour.a, 0.0, 1.0);
    bool unlit = (m.flags & k_material_unlit) != 0u;
    vec3 emission = unlit ? vec3(0.0) : m.emissive_cutoff.rgb;
    vec3 radiance = alpha * scattered(m, centre, radius, look) + emission;
    out_passes = vec4(1.0 - cover * alpha);
    out_radiance = vec4(storable_radiance(radiance * (cover * frame.exposure.x)), cover * alpha);
}
