/// Unit vectors as points of a square: the octahedron |x| + |y| + |z| = 1 with its lower half folded
/// outwards. Meyer et al. 2010, "On floating-point normal vectors".

/// −1 or 1; never 0, so that folding keeps vectors on the axes.
vec2 sign_not_zero(vec2 v) {
    return mix(vec2(-1.0), vec2(1.0), greaterThanEqual(v, vec2(0.0)));
}

/// @param n  any finite vector but 0 (0 gives +Z)
/// @return   [−1, 1]²
vec2 octahedral_from_unit(vec3 n) {
    float sum = abs(n.x) + abs(n.y) + abs(n.z);
    vec2 p = sum > 0.0 ? n.xy / sum : vec2(0.0);
    return n.z >= 0.0 ? p : (1.0 - abs(p.yx)) * sign_not_zero(p);
}

/// @return  unit vector, for any input in [−1, 1]²
vec3 unit_from_octahedral(vec2 p) {
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    float fold = max(-n.z, 0.0);
    n.xy -= sign_not_zero(n.xy) * fold;
    return normalize(n);
}

/// For 16-bit UNORM channels: 65535 steps would put 0 between two of them, so one is given away and the axes
/// are exact.
vec2 unorm16_from_octahedral(vec2 p) {
    return (p * 32767.0 + 32767.0) / 65535.0;
}

vec2 octahedral_from_unorm16(vec2 stored) {
    return clamp((stored * 65535.0 - 32767.0) / 32767.0, -1.0, 1.0);
}
