const float k_pi = 3.14159265358979;

/// Largest radiance that is written to half-float targets: below the format's 65504, so that blending two of them
/// saturates in the blend unit's float arithmetic and not in a shader.
const float k_max_radiance = 60000.0;
