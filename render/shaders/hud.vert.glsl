// Dear ImGui's triangles: pixels from the upper left corner to clip space.
#include "render/shaders/shared/bindings.h"

layout(location = 0) in vec2 position_px;
layout(location = 1) in vec2 glyph_uv;
layout(location = 2) in vec4 colour;

layout(location = 0) uniform vec4 clip_from_px;  ///< xy: scale, zw: offset

out vec2 uv;
out vec4 tint;

void main() {
    uv = glyph_uv;
    tint = colour;
    gl_Position = vec4(position_px * clip_from_px.xy + clip_from_px.zw, 0.0, 1.0);
}
