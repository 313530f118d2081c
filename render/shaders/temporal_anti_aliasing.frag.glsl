// The picture as the mean of this one and earlier ones, found again where what is seen now was then.
// Defines: REPROJECT: the camera moved, or there is no past; MOTION: things moved; CLAMP: earlier colours are kept within
// those around the pixel now. Where neither camera nor things moved, a pixel's past is the pixel itself.
#include "motion.glsl"
#include "temporal.glsl"
#include "temporal_past.glsl"

layout(binding = UNIT_PASS) uniform sampler2D scene_colour;

layout(location = 0) out vec4 out_history;
layout(location = 1) out vec4 out_radiance;

vec3 present_at(ivec2 pixel) {
    return compressed(storable_radiance(texelFetch(scene_colour, pixel, 0).rgb));
}

struct Present {
    vec3 colour;
    ColourBox around;
};

Present present(ivec2 pixel) {
    Present p;
    p.colour = present_at(pixel);
#if CLAMP
    vec3 low = p.colour, high = p.colour, sum = p.colour, sum2 = p.colour * p.colour;
    ivec2 last = ivec2(frame.size_px.xy) - 1;
    // Four neighbours: with the corners it would cost half as much again, and pictures look alike.
    const ivec2 beside[4] = ivec2[](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
    for (int i = 0; i < 4; ++i) {
        vec3 c = present_at(clamp(pixel + beside[i], ivec2(0), last));
        low = min(low, c);
        high = max(high, c);
        sum += c;
        sum2 += c * c;
    }
    p.around = colour_box(low, high, sum, sum2);
#endif
    return p;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Present now = present(pixel);
    Past before = past(pixel);
    vec3 colour = now.colour;
    Kept keep = Kept(before.depth, 1u, 0u, before.moved);
    bool known = temporal.history.z > 0.0 && before.was.pictures > 0u && is_colour(before.colour);
#if CLAMP
    vec3 likely = clamp(before.colour, now.around.low, now.around.high);
    bool unlikely = any(notEqual(likely, before.colour));
    if (before.missed && unlikely) {
        // A thing thinner than a pixel is seen in some pictures only. It is believed in for as long as it takes all samples to
        // come by that are a quarter of a pixel apart; where it has gone away nevertheless, its trail is as short.
        keep.misses = before.was.misses + 1u;
        known = known && keep.misses <= k_most_misses;
    } else {
        before.colour = likely;
    }
#endif
    if (known) {
        bool is_young = before.was.pictures < k_most_pictures;
        float fair_share = is_young ? 1.0 / float(before.was.pictures + 1u) : 0.0;
        colour = mix(before.colour, colour, max(max(fair_share, temporal.history.x), before.least_share));
        keep.pictures = before.was.pictures + 1u;
    } else {
        keep.depth = before.near_depth;
        keep.misses = 0u;
    }
    out_radiance = vec4(expanded(colour), 1.0);
    out_history = vec4(out_radiance.rgb, stored(keep));
}
