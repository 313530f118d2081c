// What a pixel showed in the picture before. Defines: REPROJECT, MOTION, as temporal_anti_aliasing.frag.glsl has them.
#include "motion.glsl"
#include "temporal.glsl"

layout(binding = UNIT_PASS + 1) uniform sampler2D history;  ///< linear; alpha: see temporal.glsl
layout(binding = UNIT_PASS + 2) uniform sampler2D depth_target;
layout(binding = UNIT_PASS + 3) uniform sampler2D motion_target;

/// Nearest of the pixels around one: edges move with what is before them (Karis 2014).
struct Nearest {
    ivec2 pixel;
    float depth;
    float slope;  ///< difference to the farthest
};

Nearest nearest(ivec2 pixel) {
    // Each gather at a corner of the pixel brings four of the nine: x upper left, y upper right, z lower right, w lower left.
    vec2 low = vec2(pixel) * frame.size_px.zw, high = vec2(pixel + 1) * frame.size_px.zw;
    vec4 a = textureGather(depth_target, low);
    vec4 b = textureGather(depth_target, vec2(high.x, low.y));
    vec4 c = textureGather(depth_target, vec2(low.x, high.y));
    vec4 d = textureGather(depth_target, high);
    float rows[9] = float[](a.w, a.z, b.z, a.x, a.y, b.y, c.x, d.x, d.y);
    int found = 4;
    float depth = rows[4], farthest = rows[4];
    for (int i = 0; i < 9; ++i) {
        farthest = min(farthest, rows[i]);
        if (rows[i] > depth) {
            depth = rows[i];
            found = i;
        }
    }
    ivec2 last = ivec2(frame.size_px.xy) - 1;  // beyond which there are copies of the rim
    return Nearest(clamp(pixel + ivec2(found % 3, found / 3) - 1, ivec2(0), last), depth, depth - farthest);
}

#if REPROJECT || MOTION
/// Five taps of the bilinear filter for the sixteen of the cubic: corners weigh next to nothing (Jimenez 2016, "Filmic SMAA").
vec3 sample_history(vec2 place_px) {
    vec2 middle = floor(place_px - 0.5) + 0.5;
    vec2 t = place_px - middle;
    vec4 x = catmull_rom(t.x), y = catmull_rom(t.y);
    vec2 inner = vec2(x.y + x.z, y.y + y.z);
    vec2 at = (middle + vec2(x.z, y.z) / inner) * frame.size_px.zw;
    vec2 before = (middle - 1.0) * frame.size_px.zw, behind = (middle + 2.0) * frame.size_px.zw;
    float weights[5] = float[](inner.x * inner.y, x.x * inner.y, x.w * inner.y, inner.x * y.x, inner.x * y.w);
    vec2 places[5] = vec2[](at, vec2(before.x, at.y), vec2(behind.x, at.y), vec2(at.x, before.y), vec2(at.x, behind.y));
    vec3 sum = vec3(0.0);
    float weight = 0.0;
    for (int i = 0; i < 5; ++i) {
        sum += weights[i] * compressed(temporal.history.y * textureLod(history, places[i], 0.0).rgb);
        weight += weights[i];
    }
    return sum / weight;
}
#endif

struct Past {
    vec3 colour;
    Kept was;           ///< no pictures: nothing is known
    float depth;        ///< to be kept
    float near_depth;   ///< of what is seen now
    float least_share;  ///< of the present
    bool missed;        ///< what was there, thinner than a pixel, is between the samples now
    bool moved;         ///< what is there now
};

#if REPROJECT || MOTION
/// Of something at rest that is not seen now: whether its own motion on the screen is so much that of what is seen in its
/// place that it must still be there.
bool is_still_there(vec2 near_px, float depth, vec2 motion) {
    const float least_parallax_px = 0.25;
#if REPROJECT
    vec4 then = temporal.past_from_present * vec4(2.0 * near_px * frame.size_px.zw - 1.0, depth, 1.0);
    return distance(motion_px(near_px, then), motion) < least_parallax_px;
#else
    return true;
#endif
}

Past past(ivec2 pixel) {
    Nearest near = nearest(pixel);
    vec2 near_px = vec2(near.pixel) + 0.5;
    vec2 motion = vec2(0.0);
    float should_be = near.depth;
    float slack = k_kept_depth_slack;
    bool moved = false;
#if REPROJECT
    vec4 then = temporal.past_from_present * vec4(2.0 * near_px * frame.size_px.zw - 1.0, near.depth, 1.0);
    motion = motion_px(near_px, then);
    should_be = then.z / then.w;
#endif
#if MOTION
    vec2 own_motion = texelFetch(motion_target, near.pixel, 0).xy;
    moved = !is_at_rest(own_motion);
    if (moved) {
        motion = own_motion;
        // Its depth then is not known, and things come closer by a few per cent from picture to picture.
        const float closer = 0.2;
        should_be = near.depth;
        slack += closer;
    }
#endif
    vec2 place_px = gl_FragCoord.xy - motion;
    bool is_inside = all(greaterThanEqual(place_px, vec2(0.0))) && all(lessThan(place_px, frame.size_px.xy));
    if (!is_inside) place_px = gl_FragCoord.xy;
    Kept was = kept(texelFetch(history, ivec2(place_px), 0).a);
    // What moved and has gone on hid what is there now, however close to it: a foot on the ground is nearer by less than
    // depths are known.
    bool gone_on = was.moved && !moved;
    bool hidden = gone_on || was_hidden(was.depth, should_be, near.slope, slack);
    bool missed = hidden && !moved && !was.moved && is_still_there(near_px, was.depth, motion);
    if (!is_inside || (hidden && !missed)) was.pictures = 0u;
    // What is not seen has not gone away.
    float depth = missed ? was.depth : near.depth;
    return Past(sample_history(place_px), was, depth, near.depth, share_against_blur(fract(place_px - 0.5)), missed, moved);
}
#else
Past past(ivec2 pixel) {
    vec4 texel = texelFetch(history, pixel, 0);
    Kept was = kept(texel.a);
    Nearest near = nearest(pixel);
    if (was.moved) was.pictures = 0u;  // it has gone on, or come to rest
    bool missed = !was.moved && was_hidden(was.depth, near.depth, near.slope, k_kept_depth_slack);
    float depth = missed ? was.depth : near.depth;
    return Past(compressed(temporal.history.y * texel.rgb), was, depth, near.depth, 0.0, missed, false);
}
#endif
