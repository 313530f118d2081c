// Colours are the display's own; glyphs are coverage.
#include "render/shaders/shared/bindings.h"

layout(binding = UNIT_PASS) uniform sampler2D glyphs;  ///< R8

in vec2 uv;
in vec4 tint;
layout(location = 0) out vec4 out_colour;

void main() {
    float alpha = tint.a * textureLod(glyphs, uv, 0.0).r;
    out_colour = vec4(tint.rgb * alpha, alpha);
}
