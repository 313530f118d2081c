// What a normal map says at a point, and the frame in which it says it.
struct TangentSpace {
    vec3 tangent;  ///< unit length, or zero where there is no map
    vec3 map;      ///< unit length; y along cross(normal, tangent)
};

/// Of unit length but for rounding.
vec3 tilted_normal(TangentSpace s, vec3 normal) {
    return s.tangent * s.map.x + cross(normal, s.tangent) * s.map.y + normal * s.map.z;
}
