/// Share of a light's illuminance·m² that arrives at a distance: 1/d² inside the window max(0, 1 − (d/r)⁴)²,
/// which ends at the light's radius without a kink. Karis 2013, "Real shading in Unreal Engine 4", eq. 9.

/// Lamps are not points: no surface comes nearer to their middle than this, which also keeps 1/d² finite.
const float k_min_distance_m = 0.01;

float distance_attenuation(float distance_m, float radius_m) {
    if (!(distance_m < radius_m)) return 0.0;
    float ratio = distance_m / radius_m;
    float ratio2 = ratio * ratio;
    float window = 1.0 - ratio2 * ratio2;
    float bounded = max(distance_m, k_min_distance_m);
    return window * window / (bounded * bounded);
}

/// Narrower edges than this are drawn as this one: equal inner and outer cones have no edge to divide by.
const float k_min_cone_edge = 1e-4;

/// 1 inside the inner cone, 0 outside the outer, squared ramp between (KHR_lights_punctual).
float cone_attenuation(float cos_angle, float cos_inner, float cos_outer) {
    float ramp = clamp((cos_angle - cos_outer) / max(cos_inner - cos_outer, k_min_cone_edge), 0.0, 1.0);
    return ramp * ramp;
}
