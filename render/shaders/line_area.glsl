// How much of the pixels beside a line of edges a straight silhouette would cover, which the edges are stairs of
// (Reshetov 2009, "Morphological antialiasing"; here in closed form instead of from a table).
//
//   Where an edge leaves the line, the silhouette comes from half way along that edge, and sinks to the line in the
//   line's middle:
//                   |
//      height 0.5  -.
//                   |''--..                        ..--''|
//      the line     +======''--..==============..--======+
//                                middle
//
//   With both ends on one side it rises again; with ends on opposite sides the two halves are one straight line.

/// Where an edge leaves a line: half a pixel above or below.
const float k_step_height = 0.5;

/// Between the line and a slope that falls from k_step_height at 0 to the line at length / 2, over the pixel [at, at + 1].
float slope_area(float at, float length) {
    float half_length = 0.5 * length;
    vec2 t = min(vec2(at, at + 1.0), half_length);
    vec2 integral = t - t * t / length;
    return k_step_height * (integral.y - integral.x);
}

/// What a line says of a pixel at it.
/// @param behind, ahead   pixels of the line before and after this one
/// @param height_behind, height_ahead  of its ends: 1 the silhouette comes from above, −1 from below, 0 neither
/// @return  share of the pixel above the line that belongs to what is below (x), and the other way round (y)
vec2 line_areas(float behind, float ahead, float height_behind, float height_ahead) {
    float length = behind + ahead + 1.0;
    float rising = slope_area(behind, length);
    float falling = slope_area(ahead, length);
    vec2 above = vec2(height_behind > 0.0 ? rising : 0.0, height_ahead > 0.0 ? falling : 0.0);
    vec2 below = vec2(height_behind < 0.0 ? rising : 0.0, height_ahead < 0.0 ? falling : 0.0);
    return vec2(above.x + above.y, below.x + below.y);
}

/// The height of an end. Where edges leave on both sides, the silhouette is taken to be straight.
/// @param other_up, other_down  the line's other end
float end_height(bool up, bool down, bool other_up, bool other_down) {
    if (up && down) return float(other_down) - float(other_up);
    return float(up) - float(down);
}
