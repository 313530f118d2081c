// The sums of the local and of the directional lights that reach a surface. Define LOCAL_LIGHTS: which local ones are
// asked.
#include "local_light.glsl"
#include "render/shaders/shared/light_cells.h"  // here, since files are included once, be it in a branch that is dropped

#define LOCAL_LIGHTS_NONE 0
#define LOCAL_LIGHTS_ALL 1   ///< every one of the frame
#define LOCAL_LIGHTS_CELL 2  ///< those of the pixel's cell
#define LOCAL_LIGHTS_TILE 3  ///< those that light_tiles.comp.glsl found for the tile

#if LOCAL_LIGHTS == LOCAL_LIGHTS_CELL
#include "light_cells.glsl"
#elif LOCAL_LIGHTS == LOCAL_LIGHTS_TILE
#include "tiles.glsl"
flat in uvec2 tile_range;
#endif

vec3 directional_lights(Surface s, vec3 to_eye) {
    vec3 sum = vec3(0.0);
    for (uint i = frame.counts.x; i < frame.counts.x + frame.counts.z; ++i)
        sum += lights[i].intensity_cos_outer.rgb * reflected(s, to_eye, -lights[i].direction_cos_inner.xyz);
    return sum;
}

/// @param distance_m  from the eye to the surface, along the view
vec3 local_lights(Surface s, vec3 position, vec3 to_eye, float distance_m) {
    vec3 sum = vec3(0.0);
#if LOCAL_LIGHTS == LOCAL_LIGHTS_ALL
    for (uint i = 0u; i < frame.counts.x; ++i)
        sum += local_light(lights[i], s, position, to_eye);
#elif LOCAL_LIGHTS == LOCAL_LIGHTS_CELL
    uvec2 range = lights_of_pixel(uvec2(gl_FragCoord.xy), distance_m);
    for (uint i = range.x; i < range.x + range.y; ++i)
        sum += local_light(lights[light_entries[i]], s, position, to_eye);
#elif LOCAL_LIGHTS == LOCAL_LIGHTS_TILE
    for (uint i = tile_range.x; i < tile_range.x + tile_range.y; ++i)
        sum += local_light(lights[tile_entries[i]], s, position, to_eye);
#endif
    return sum;
}
