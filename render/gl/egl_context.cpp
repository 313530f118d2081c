#include "render/gl/egl_context.h"

#include <epoxy/egl.h>

#include <array>
#include <cstdio>
#include <string>

#include "render/gl/context.h"

namespace rambla::render::gl {

struct EglContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

namespace {

std::string egl_error() {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "0x%04x", static_cast<unsigned>(eglGetError()));
    return text.data();
}

// eglGetPlatformDisplayEXT and not the EGL 1.5 entry without suffix, for which libepoxy 1.5.10 finds no
// provider before a display exists. The display is one per process and stays initialised: terminating it
// would pull the ground from under contexts of other threads.
EGLDisplay open_display() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        throw MissingFeature("EGL_MESA_platform_surfaceless: EGL offers no drawing without a window");
    }
    const EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
        throw MissingFeature("EGL: no surfaceless display (EGL error " + egl_error() + ")");
    }
    for (const char* extension : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"}) {
        if (!epoxy_has_egl_extension(display, extension)) throw MissingFeature(extension);
    }
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) throw MissingFeature("EGL: no OpenGL (only OpenGL ES)");
    return display;
}

EGLContext create_context(EGLDisplay display, int major, int minor, bool debug) {
    const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           major,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           minor,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_CONTEXT_OPENGL_DEBUG,
                                           debug ? EGL_TRUE : EGL_FALSE,
                                           EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
}

}  // namespace

EglContext::EglContext(const Options& options) : state_{std::make_unique<State>()} {
    state_->display = open_display();
    state_->context = create_context(state_->display, 4, 5, options.debug);
    if (state_->context == EGL_NO_CONTEXT && options.any_version) {
        state_->context = create_context(state_->display, 3, 1, options.debug);
    }
    if (state_->context == EGL_NO_CONTEXT) {
        throw MissingFeature("OpenGL 4.5 core profile: the driver makes no such context (EGL error " +
                             egl_error() + ")");
    }
    if (eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context) == EGL_FALSE) {
        const std::string error = egl_error();
        eglDestroyContext(state_->display, state_->context);
        throw MissingFeature("EGL: the context cannot be made current (EGL error " + error + ")");
    }
}

EglContext::~EglContext() {
    eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(state_->display, state_->context);
}

}  // namespace rambla::render::gl
