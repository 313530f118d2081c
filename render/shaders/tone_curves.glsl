/// Curves from pre-exposed scene light to display light, applied to each channel. All map 0 to 0, rise
/// monotonically, and end at 1; diffuse white in the sun lands near 0.88 in sRGB.

/// Scene light that becomes display white in the curves that have a white point. Diffuse white under noon sun
/// and sky is about 1.2; what is brighter than 3 (glints, lamps) has no detail worth keeping.
const float k_white_point = 3.0;

/// L·(1 + L/L_white²)/(1 + L). Reinhard et al. 2002, eq. 4.
vec3 tone_reinhard(vec3 x) {
    vec3 bounded = min(x, vec3(k_white_point));
    return bounded * (1.0 + bounded / (k_white_point * k_white_point)) / (1.0 + bounded);
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

vec3 tone_filmic(vec3 x) {
    vec3 bounded = min(x, vec3(k_white_point));
    return filmic_shape(k_filmic_scale * bounded) / filmic_shape(vec3(k_filmic_scale * k_white_point));
}

/// x(2.51x + 0.03)/(x(2.43x + 0.59) + 0.14): Narkowicz 2015, "ACES filmic tone mapping curve". It passes 1
/// near x = 5.9 and tends to 1.033: cut off at 1.
vec3 tone_aces(vec3 x) {
    return min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), vec3(1.0));
}
