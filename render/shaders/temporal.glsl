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

/// False for what is no number, which would stay for ever: compressed lumas lie in [0, 1), and the cubic that finds them
/// between pixels leaves that by little.
bool is_colour(vec3 c) {
    return abs(c.x) < 2.0 && abs(c.y) + abs(c.z) < 8.0;
}

/// Colours around a pixel, as a box that holds those that the pixel may have had before.
struct ColourBox {
    vec3 low;
    vec3 high;
};

/// Standard deviations from the mean, within the least and the greatest: with less, pixels that an edge nearly fills would
/// lose their share of it whenever the sample falls to the other side.
const float k_box_deviations = 1.25;

/// Salvi 2016, "An excursion in temporal supersampling". @param sum, sum2  of a pixel and its four neighbours, and of their squares
ColourBox colour_box(vec3 low, vec3 high, vec3 sum, vec3 sum2) {
    vec3 mean = sum / 5.0;
    vec3 reach = k_box_deviations * sqrt(max(sum2 / 5.0 - mean * mean, vec3(0.0)));
    return ColourBox(max(low, mean - reach), min(high, mean + reach));
}

/// What is kept beside a colour of the history.
struct Kept {
    float depth;    ///< nearest of nine pixels, [0, 1]; at most k_kept_depth_slack of it too small
    uint pictures;  ///< that the colour is the mean of, up to k_most_pictures; 0: nothing is known
    uint misses;    ///< how many pictures in a row have not seen what the colour came from, up to k_most_misses
    bool moved;     ///< that came from something that moved by itself
};

/// All of it shares one half float: sign, exponent and five bits of the mantissa, and the rest for the numbers.
const uint k_most_pictures = 7u;
const uint k_most_misses = 3u;
const uint k_number_bits = 31u;
const uint k_sign_bit = 0x8000u;
/// A perspective's depths are a share of the near plane's distance each; in a parallel view, where they are a share of the
/// whole range, only what lies some per cent of that before something else is known to have hidden it. The half floats of
/// full precision hold those from the near plane to 2⁻²⁸ of that.
const float k_depth_scale = 16384.0;
const float k_least_depth = 1.0 / (16384.0 * 16384.0);
/// Bits cut off, and the half float's own rounding.
const float k_kept_depth_slack = 1.0 / 32.0 + 1.0 / 1024.0;

float stored(Kept k) {
    uint bits = packHalf2x16(vec2(k_depth_scale * clamp(k.depth, k_least_depth, 1.0), 0.0)) & ~k_number_bits;
    uint numbers = min(k.pictures, k_most_pictures) | min(k.misses, k_most_misses) << 3;
    return unpackHalf2x16(bits | numbers | (k.moved ? k_sign_bit : 0u)).x;
}

Kept kept(float alpha) {
    uint bits = packHalf2x16(vec2(alpha, 0.0)) & 0xffffu;
    float depth = abs(unpackHalf2x16(bits & ~k_number_bits).x) / k_depth_scale;
    if (!(depth >= k_least_depth && depth <= 1.0)) return Kept(0.0, 0u, 0u, false);  // no number: nothing
    return Kept(depth, bits & k_most_pictures, (bits >> 3) & k_most_misses, (bits & k_sign_bit) != 0u);
}

/// Whether something else hid then what is seen now. All are depths (reversed), nearest of nine pixels: next to an edge a
/// pixel's past is mixed with what is before it.
/// @param was     what is kept
/// @param should  what would be there, had nothing hidden it
/// @param slope   how much the nine pixels differ now: a surface seen at a grazing angle may be a pixel off
/// @param slack   as a share of the depth
bool was_hidden(float was, float should, float slope, float slack) {
    return !(was <= max(should, k_least_depth) * (1.0 + slack) + slope);
}

/// Share of the present in a pixel where earlier pictures are found between their pixels: each such resampling blurs, most
/// half way between two, not at all on one. More of the present keeps that within bounds: at a fifth, stripes of five pixels keep 83 % of
/// their contrast, at a twentieth they would keep half.
/// @param part  of a pixel, [0, 1)
float share_against_blur(vec2 part) {
    const float most = 0.2;
    vec2 off = 4.0 * part * (1.0 - part);
    return most * max(off.x, off.y);
}

/// Weights of the four samples along an axis between the middle ones of which a place lies. Catmull and Rom 1974.
vec4 catmull_rom(float t) {
    return vec4(t * (-0.5 + t * (1.0 - 0.5 * t)), 1.0 + t * t * (1.5 * t - 2.5), t * (0.5 + t * (2.0 - 1.5 * t)),
                t * t * (0.5 * t - 0.5));
}
