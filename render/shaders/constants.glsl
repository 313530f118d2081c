const float k_pi = 3.14159265358979;

/// Largest radiance that a shader writes to half-float targets, whose own limit is 65504. Blended sums of several
/// such values may still reach infinity, which tone mapping shows as white.
const float k_max_radiance = 60000.0;
