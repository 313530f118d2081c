#include <epoxy/gl.h>

#include <algorithm>
#include <array>

#include "render/gl/context.h"
#include "render/gl/egl_context.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {

namespace {

std::string text_of(GLenum what) {
    const GLubyte* text = glGetString(what);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

std::int64_t integer_of(GLenum what) {
    GLint64 value = 0;
    glGetInteger64v(what, &value);
    return value;
}

bool is_software(const std::string& renderer) {
    constexpr std::array<const char*, 4> names{"llvmpipe", "softpipe", "SWR", "SwiftShader"};
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

constexpr std::array k_optional_extensions{"GL_ARB_indirect_parameters",
                                           "GL_ARB_pipeline_statistics_query",
                                           "GL_ARB_shader_viewport_layer_array",
                                           "GL_EXT_texture_filter_anisotropic",
                                           "GL_EXT_texture_compression_s3tc",
                                           "GL_KHR_parallel_shader_compile",
                                           "GL_KHR_shader_subgroup",
                                           "GL_ARB_bindless_texture",
                                           "GL_ARB_sparse_texture"};

// RGTC, for one and two channels, is part of OpenGL.
constexpr std::array k_block_extensions{"GL_EXT_texture_compression_s3tc", "GL_EXT_texture_sRGB"};

void choose_compression(DeviceInfo& info) {
    const auto missing = std::find_if_not(k_block_extensions.begin(), k_block_extensions.end(),
                                          [](const char* name) { return epoxy_has_gl_extension(name); });
    if (info.software) {
        info.block_compression_reason =
            "a rasteriser on the CPU decodes blocks anew for every sample, which takes two to three times as "
            "long";
    } else if (missing != k_block_extensions.end()) {
        info.block_compression_reason = std::string{*missing} + " is missing";
    } else {
        info.block_compression = true;
        info.block_compression_reason = "a fourth of the memory and of the bandwidth, or less";
    }
}

/// Storage blocks that light_tiles.comp.glsl has of its own.
constexpr std::int64_t k_tile_lists = 6;

struct RequiredLimit {
    const char* name;
    GLenum what;
    std::int64_t at_least;
};
// Storage blocks in vertex shaders hold instances, materials, joints and the two of morphs; GL 4.5 itself
// promises none there, eight in fragments and compute shaders, and eight binding points, of which the tiles'
// lists need more.
constexpr std::array k_limits{
    RequiredLimit{"GL_MAX_TEXTURE_SIZE", GL_MAX_TEXTURE_SIZE, 8192},
    RequiredLimit{"GL_MAX_COLOR_ATTACHMENTS", GL_MAX_COLOR_ATTACHMENTS, 8},
    RequiredLimit{"GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS", GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, 5},
    RequiredLimit{"GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS", GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, 4},
    RequiredLimit{"GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS", GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 7},
    RequiredLimit{"GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS", GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS,
                  BINDING_PASS_STORAGE + k_tile_lists},
    RequiredLimit{"GL_MAX_SHADER_STORAGE_BLOCK_SIZE", GL_MAX_SHADER_STORAGE_BLOCK_SIZE,
                  std::int64_t{1} << 24},
    RequiredLimit{"GL_MAX_TEXTURE_IMAGE_UNITS", GL_MAX_TEXTURE_IMAGE_UNITS, 16},
    RequiredLimit{"GL_MAX_UNIFORM_BLOCK_SIZE", GL_MAX_UNIFORM_BLOCK_SIZE, 0},
    RequiredLimit{"GL_MAX_COMPUTE_SHARED_MEMORY_SIZE", GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, 0},
    RequiredLimit{"GL_MAX_SAMPLES", GL_MAX_SAMPLES, 0},
    RequiredLimit{"GL_NUM_PROGRAM_BINARY_FORMATS", GL_NUM_PROGRAM_BINARY_FORMATS, 0},
};

}  // namespace

namespace gl {

DeviceInfo describe_device() {
    DeviceInfo info;
    info.vendor = text_of(GL_VENDOR);
    info.renderer = text_of(GL_RENDERER);
    info.version = text_of(GL_VERSION);
    info.shading_language = text_of(GL_SHADING_LANGUAGE_VERSION);
    info.software = is_software(info.renderer);
    choose_compression(info);
    const int version = epoxy_gl_version();
    info.features.push_back({.name = "OpenGL 4.5 core profile", .present = version >= 45, .required = true});
    info.features.push_back(
        {.name = "GL_ARB_shader_draw_parameters",
         .present = version >= 46 || epoxy_has_gl_extension("GL_ARB_shader_draw_parameters"),
         .required = true});
    for (const char* name : k_optional_extensions) {
        info.features.push_back({.name = name, .present = epoxy_has_gl_extension(name), .required = false});
    }
    if (version < 45) return info;  // asking for the limits would be an error
    for (const RequiredLimit& limit : k_limits) {
        info.limits.push_back(
            {.name = limit.name, .value = integer_of(limit.what), .required = limit.at_least});
    }
    return info;
}

void require_features(const DeviceInfo& device) {
    for (const DeviceFeature& feature : device.features) {
        if (feature.present || !feature.required) continue;
        throw MissingFeature(feature.name + ": not offered by " + device.renderer + ", " + device.version);
    }
    for (const DeviceLimit& limit : device.limits) {
        if (limit.value >= limit.required) continue;
        throw MissingFeature(limit.name + ": " + device.renderer + " offers " + std::to_string(limit.value) +
                             ", needed are " + std::to_string(limit.required));
    }
}

}  // namespace gl

DeviceInfo query_device(const WindowContext& window) {
    if (!window.make_current) {
        const gl::EglContext context{{.debug = false, .any_version = true}};
        return gl::describe_device();
    }
    window.make_current();
    DeviceInfo info = gl::describe_device();
    if (window.release) window.release();
    return info;
}

}  // namespace rambla::render
