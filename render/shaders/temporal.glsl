// What temporal anti-aliasing is made of, without textures.
#include "colour.glsl"

/// Colours are compared and averaged as luma and two differences (YCoCg: Malvar and Sullivan 2003), divided by 1 + luma.
/// The mean of such colours is that of what Reinhard's curve would show, so that one bright sample among dark ones does not
/// decide alone: edges before bright things look as smooth as others (Karis 2014, "High-quality temporal supersampling").
vec3 compressed(vec3 radiance) {
    vec3 c = vec3(0.25 * (radiance.r + radiance.b) + 0.5 * radiance.g, 0.5 * (radiance.r - radiance.b),
                  0.5 * radiance.g - 0.25 * (radiance.r + radiance.b));
    return c / (1.0 + c.x);
}

/// The other way. What lies outside of the space that compressed() maps to comes back as a storable radiance.
vec3 expanded(vec3 c) {
    float rest = max(1.0 - c.x, 1.0 / k_max_radiance);
    float green_free = c.x - c.z;
    return storable_radiance(vec3(green_free + c.y, c.x + c.z, green_free - c.y) / rest);
}

/// Colours around a pixel, as a box that holds those that the pixel may have had before.
struct ColourBox {
    vec3 low;
    vec3 high;
};

/// Standard deviations from the mean, within the least and the greatest: with less, pixels that an edge nearly fills would
/// lose their share of it whenever the sample falls to the other side.
const float k_box_deviations = 1.25;

/// Salvi 2016, "An excursion in temporal supersampling". @param sum, sum2  of nine colours, and of their squares
ColourBox colour_box(vec3 low, vec3 high, vec3 sum, vec3 sum2) {
    vec3 mean = sum / 9.0;
    vec3 reach = k_box_deviations * sqrt(max(sum2 / 9.0 - mean * mean, vec3(0.0)));
    return ColourBox(max(low, mean - reach), min(high, mean + reach));
}

/// What is kept beside a colour of the history, in one half float: the greatest depth around the pixel, with five bits of
/// mantissa, and in the five bits below those how many pictures the colour is the mean of.
const uint k_most_pictures = 31u;
/// A perspective's depths are a share of the near plane's distance each; in a parallel view, where they are a share of the
/// whole range, only what lies some per cent of that before something else is known to have hidden it.
/// Depths of a half float's full precision: from the near plane to 2⁻²⁸ of that, scaled to 2¹⁴ … 2⁻¹⁴.
const float k_depth_scale = 16384.0;
/// A kept depth is at most that much too small, as a share: bits cut off and the half float's rounding.
const float k_kept_depth_slack = 1.0 / 32.0 + 1.0 / 1024.0;

float kept(float depth, uint pictures) {
    uint bits = packHalf2x16(vec2(k_depth_scale * clamp(depth, 0.0, 1.0), 0.0));
    return unpackHalf2x16((bits & ~k_most_pictures) | min(pictures, k_most_pictures)).x;
}

struct Kept {
    float depth;
    uint pictures;
};
Kept unkept(float alpha) {
    uint bits = packHalf2x16(vec2(alpha, 0.0)) & 0xffffu;
    float depth = unpackHalf2x16(bits & ~k_most_pictures).x / k_depth_scale;
    return depth >= 0.0 && depth <= 1.0 ? Kept(depth, bits & k_most_pictures) : Kept(0.0, 0u);  // no number: nothing
}

/// Whether something else hid then what is seen now. All are depths (reversed), nearest of nine pixels.
/// @param was     what is kept
/// @param should  what would be there, had nothing hidden it
/// @param slope   how much the nine pixels differ now: a surface seen at a grazing angle may be a pixel off
/// @param slack   as a share of the depth
bool was_hidden(float was, float should, float slope, float slack) {
    return !(was <= should * (1.0 + slack) + slope);
}

/// Weights of the four samples along an axis between the middle ones of which a place lies. Catmull and Rom 1974.
vec4 catmull_rom(float t) {
    return vec4(t * (-0.5 + t * (1.0 - 0.5 * t)), 1.0 + t * t * (1.5 * t - 2.5), t * (0.5 + t * (2.0 - 1.5 * t)),
                t * t * (0.5 * t - 0.5));
}
