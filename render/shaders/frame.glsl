#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/frame_uniforms.h"

layout(std140, binding = BINDING_FRAME_UNIFORMS) uniform FrameBlock {
    FrameUniforms frame;
};
