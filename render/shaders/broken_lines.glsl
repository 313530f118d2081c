// Edges of what a picture shows, whatever its colours (Shishkovtsov 2005, "Deferred shading in S.T.A.L.K.E.R.", GPU
// Gems 2, ch. 9): where the middle of nine depths does not lie on the straight line between opposite neighbours, or where
// normals turn.

/// Depth is one over distance (or linear, in orthographic views), so that planes are straight in it to the bit of a
/// float. Bends beyond this share of the nearest depth of the three are steps or folds.
const float k_bend = 0.01;
/// Cosine of 45°: normal maps turn normals too, and what they show is no edge.
const float k_turn_cosine = 0.7071;

float is_broken(float a, float middle, float b) {
    precise float bend = abs((a - middle) + (b - middle));
    precise float least = k_bend * max(middle, max(a, b));
    return bend > least ? 1.0 : 0.0;
}

/// @param nine  depths as in edge_criterion.glsl, 0 infinitely far
/// @return      how many of the four lines through the middle are broken
float broken_lines(float nine[9]) {
    float m = nine[4];
    return is_broken(nine[3], m, nine[5]) + is_broken(nine[1], m, nine[7]) + is_broken(nine[0], m, nine[8]) +
           is_broken(nine[2], m, nine[6]);
}

/// @return  to how many of the four beside it a normal has turned
float turned_normals(vec3 m, vec3 n, vec3 s, vec3 e, vec3 w) {
    precise vec4 cosines = vec4(dot(m, n), dot(m, s), dot(m, e), dot(m, w));
    return dot(vec4(lessThan(cosines, vec4(k_turn_cosine))), vec4(1.0));
}
