/// Where exposure goes at an average luminance: the share `strength` of the stops that bring it to the key, within
/// ±range.
/// @param average  of exposed scene light, > 0
/// @param key      average that needs no change, > 0
float target_ev(float average, float key, float strength, float range_ev) {
    return clamp(-strength * log2(average / key), -range_ev, range_ev);
}

/// One frame's step to the target: ev + (target − ev)·share, where share = 1 − exp(−dt/τ) is that of
/// render/post/adaptation.h. It neither passes the target nor, at share 1, misses it by a rounding.
double followed_ev(double ev, double target, double share) {
    return share < 1.0 ? ev + (target - ev) * share : target;
}

/// What Reinhard 2003, "Parameter estimation for photographic tone reproduction", makes of a picture's luminances.
/// x: α = 0.18·4^((2·log2 L_avg − log2 L_min − log2 L_max)/(log2 L_max − log2 L_min)), which the average becomes.
/// The exponent is 0 where L_max = L_min, and held to [−1, 1], which an average between the two cannot leave, but
/// one can that outliers beyond the percentiles have drawn away.
/// y: L_white = 1.5·2^(log2 L_max − log2 L_min − 5), but at least what L_max becomes, which must not be cut off, and
/// at least 1: where nothing of the picture is brighter than display white nothing needs room, and with white at 1
/// extended Reinhard leaves light as it is. Without that, a flat grey would be its own white, and shown as white.
/// @param average, darkest, brightest  L_avg, L_min, L_max > 0
vec2 estimated_curve(float average, float darkest, float brightest) {
    float stops = log2(brightest) - log2(darkest);
    float skew = 2.0 * log2(average) - log2(darkest) - log2(brightest);
    float exponent = stops > 0.0 ? clamp(skew / stops, -1.0, 1.0) : 0.0;
    float key = 0.18 * exp2(2.0 * exponent);
    float white = max(1.5 * exp2(stops - 5.0), key * brightest / average);
    return vec2(key, max(white, 1.0));
}
