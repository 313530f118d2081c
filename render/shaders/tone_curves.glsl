/// Curves from exposed scene light ≥ 0 to display light in [0, 1]. All map 0 to 0 and rise monotonically.
/// @param white  scene light that becomes display white, in the curves that have such a point of their own choice

/// The range is open: L/(1 + L). Reinhard et al. 2002, eq. 3.
vec3 tone_reinhard(vec3 x, float white) {
    return x / (1.0 + x);
}

/// L·(1 + L/L_white²)/(1 + L). Reinhard et al. 2002, eq. 4. With white 1 it is the identity.
vec3 tone_extended(vec3 x, float white) {
    vec3 bounded = min(x, vec3(white));
    return bounded * (1.0 + bounded / (white * white)) / (1.0 + bounded);
}

/// ((x(Ax + CB) + DE)/(x(Ax + B) + DF)) − E/F with A=.15 B=.50 C=.10 D=.20 E=.02 F=.30 (Hable 2010), with the
/// constant subtracted symbolically: x·(A·x·(1 − E/F) + B·(C − E/F))/(x(Ax + B) + DF), so that 0 gives 0 and
/// no digits cancel.
vec3 filmic_shape(vec3 x) {
    const float a = 0.15, b = 0.50, c = 0.10, d = 0.20, e = 0.02, f = 0.30;
    return x * (a * (1.0 - e / f) * x + b * (c - e / f)) / (x * (a * x + b) + d * f);
}

/// Where on the curve scene light 1 lies: higher lifts the middle tones.
const float k_filmic_scale = 4.0;

/// Divided by its value at the white point.
vec3 tone_filmic(vec3 x, float white) {
    vec3 bounded = min(x, vec3(white));
    return filmic_shape(k_filmic_scale * bounded) / filmic_shape(vec3(k_filmic_scale * white));
}

/// Far beyond where this curve and the next are white, and small enough that its square is a float.
const float k_brightest = 1e6;

/// x(2.51x + 0.03)/(x(2.43x + 0.59) + 0.14): Narkowicz 2015, "ACES filmic tone mapping curve". It passes 1
/// near x = 7.2 and tends to 1.033: cut off at 1.
vec3 tone_aces(vec3 x, float white) {
    vec3 bounded = min(x, vec3(k_brightest));
    return min(bounded * (2.51 * bounded + 0.03) / (bounded * (2.43 * bounded + 0.59) + 0.14), vec3(1.0));
}

// After AgX, Sobotka's configuration for OpenColorIO (2022): colours are drawn together, each channel's logarithm goes
// through a sigmoid, and what comes out is drawn apart again. So very bright colours become white on the way, where curves
// on channels alone bend their hue. Range, slope and powers are those of AgX; its pivot, 0.5, is here what keeps middle
// grey as bright as it was.
//
// Its matrix for Rec. 709 is, within 2e-4, a mixture of each channel with one weighted mean of all, so that it and its
// inverse need no matrices.
const float k_agx_share = 0.2;
const vec3 k_agx_weights = vec3(0.2118, 0.3922, 0.3960);  ///< of sum 1: grey stays grey

/// Stops that the curve spans, from 10 below middle grey to 6.5 above it.
const float k_agx_grey = 0.18;
const float k_agx_stops_below = 10.0;
const float k_agx_stops_above = 6.5;
const float k_agx_slope = 2.0;      ///< at middle grey
const vec2 k_agx_powers = vec2(3.0, 3.25);  ///< how sharply toe and shoulder bend
const float k_agx_gamma = 2.2;      ///< of the display that the curve is drawn for

/// A sigmoid on [0, 1] through the pivot. With h(t) = t/(1 + t^p)^(1/p), which bends from slope 1 to 1, each half is
/// pivot + s·h(slope·(x − pivot)/s); the scale s that lets it end at the corner, run away and rise away from the
/// pivot, follows from s·h(slope·run/s) = rise: s^−p = ((slope·run/rise)^p − 1)/(slope·run)^p.
float agx_sigmoid(float x) {
    vec2 pivot = vec2(k_agx_stops_below / (k_agx_stops_below + k_agx_stops_above),
                      pow(k_agx_grey, 1.0 / k_agx_gamma));
    bool toe = x < pivot.x;
    float power = toe ? k_agx_powers.x : k_agx_powers.y;
    float run = toe ? pivot.x : 1.0 - pivot.x;
    float rise = toe ? pivot.y : 1.0 - pivot.y;
    float reach = k_agx_slope * run;
    float scale = reach * pow(pow(reach / rise, power) - 1.0, -1.0 / power);
    float t = k_agx_slope * abs(x - pivot.x) / scale;
    float bent = scale * t * pow(1.0 + pow(t, power), -1.0 / power);
    return pivot.y + (toe ? -bent : bent);
}

vec3 tone_agx(vec3 x, float white) {
    vec3 together = mix(x, vec3(dot(x, k_agx_weights)), k_agx_share);
    // The least positive normal float stands for black, which has no logarithm: it is far below the curve's begin.
    vec3 stops = log2(max(together, vec3(1.2e-38)) / k_agx_grey);
    vec3 place = clamp((stops + k_agx_stops_below) / (k_agx_stops_below + k_agx_stops_above), 0.0, 1.0);
    vec3 bent = vec3(agx_sigmoid(place.x), agx_sigmoid(place.y), agx_sigmoid(place.z));
    vec3 apart = (bent - k_agx_share * dot(bent, k_agx_weights)) / (1.0 - k_agx_share);
    return pow(clamp(apart, 0.0, 1.0), vec3(k_agx_gamma));
}
