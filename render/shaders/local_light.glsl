// Point and spot lights of the frame on a surface; shared by the light-volume and the blend pass.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/light.h"
#include "brdf.glsl"
#include "lights.glsl"

layout(std430, binding = BINDING_LIGHTS) readonly buffer LightBlock {
    Light lights[];
};

vec3 local_light(Light light, Surface s, vec3 position, vec3 to_eye) {
    vec3 offset = light.position_radius.xyz - position;
    float distance2 = dot(offset, offset);
    // At the light's own place there is no direction: the surface is lit head-on.
    vec3 to_light = distance2 > 1e-12 ? offset * inversesqrt(distance2) : s.normal;
    float attenuation = distance_attenuation(sqrt(distance2), light.position_radius.w) *
                        cone_attenuation(dot(-to_light, light.direction_cos_inner.xyz),
                                         light.direction_cos_inner.w, light.intensity_cos_outer.w);
    return light.intensity_cos_outer.rgb * (attenuation * reflected(s, to_eye, to_light));
}
