/// Part of a straight line, as distances along it.
struct Stretch {
    float near;
    float far;
};

/// Optical depth of a stretch of a line through a ball of haze, as a share of that through its whole middle.
///
/// The density falls from the middle as (1 − (ρ/r)²)². With b the line's distance from the middle and s the place on
/// it, counted from the point nearest to the middle, both in units of r, and h² = 1 − b², that is (h² − s²)², whose
/// integral is h⁴·s − ⅔·h²·s³ + s⁵/5; through the middle from −1 to 1 it is 16/15. Soft at its rim and wherever
/// something cuts it off: Umenhoffer, Szirmay-Kalos and Szijártó 2006, "Spherical billboards and their application to
/// rendering explosions", with a density whose integral is known.
/// @param centre     of the ball, from the line's origin
/// @param direction  unit length
/// @return  [0, 1]
float haze_share(vec3 centre, float radius, vec3 direction, Stretch stretch) {
    float along = dot(centre, direction);
    vec3 across = centre - along * direction;
    float half2 = 1.0 - dot(across, across) / (radius * radius);
    if (!(half2 > 0.0)) return 0.0;
    float half_chord = sqrt(half2);
    float s0 = clamp((stretch.near - along) / radius, -half_chord, half_chord);
    float s1 = clamp((stretch.far - along) / radius, -half_chord, half_chord);
    // Differences of powers as products: ends that are close to each other leave no digits otherwise.
    float sum2 = s0 * s0 + s1 * s1;
    float product = s0 * s1;
    float cubes = sum2 + product;
    float fifths = sum2 * sum2 + product * (sum2 - product);
    float integral = (s1 - s0) * (half2 * half2 - 2.0 / 3.0 * half2 * cubes + 0.2 * fifths);
    return clamp(15.0 / 16.0 * integral, 0.0, 1.0);
}

/// Where a line enters the ball, or where it begins if that is inside.
float haze_entry(vec3 centre, float radius, vec3 direction, float begin) {
    float along = dot(centre, direction);
    vec3 across = centre - along * direction;
    return max(begin, along - sqrt(max(radius * radius - dot(across, across), 0.0)));
}
