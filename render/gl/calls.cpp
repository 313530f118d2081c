#include "render/gl/calls.h"

#include <epoxy/gl.h>

namespace rambla::render::gl {
namespace {

CallCounts g_counts;
/// Above 0 within a call and within UncountedCalls: libepoxy asks GL for its extensions when it resolves a
/// function.
int g_depth = 0;

void count(CallKind kind) {
    if (g_depth == 0) ++g_counts.of_kind[static_cast<std::size_t>(kind)];
}

/// A wait for a fence is none where its time is 0: then it only asks. And so it is with the result of a query
/// that is taken only if it is there.
template <class... Arguments>
CallKind kind_of_call(CallKind kind, const Arguments&...) {
    return kind;
}
CallKind kind_of_call(CallKind, GLsync, GLbitfield, GLuint64 timeout_ns) {
    return timeout_ns == 0 ? CallKind::poll : CallKind::pace;
}
CallKind kind_of_call(CallKind kind, GLuint, GLenum what, GLuint64*) {
    return what == GL_QUERY_RESULT_NO_WAIT ? CallKind::query : kind;
}

/// Stands in libepoxy's table in the place of one function. That entry is a resolver at first, which puts
/// the function that it finds there and calls what stands there then: so the entry is its own during a call.
template <auto Entry, CallKind Kind>
struct Counted;

template <class Result, class... Arguments, Result (**Entry)(Arguments...), CallKind Kind>
struct Counted<Entry, Kind> {
    static inline Result (*real)(Arguments...) = nullptr;

    static Result call(Arguments... arguments) {
        struct TakeBack {
            TakeBack() { ++g_depth; }
            ~TakeBack() {
                --g_depth;
                take();
            }
        };
        count(kind_of_call(Kind, arguments...));
        const TakeBack take_back;
        *Entry = real;
        return real(arguments...);
    }
    static void take() {
        if (*Entry == &call) return;
        real = *Entry;
        *Entry = &call;
    }
};

template <CallKind Kind, auto... Entries>
void take_all() {
    (Counted<Entries, Kind>::take(), ...);
}

}  // namespace

// Every GL function that the renderer uses; a test compares the list with the sources.
void count_calls() {
    take_all<CallKind::draw, &glBlitNamedFramebuffer, &glClearNamedBufferSubData, &glClearNamedFramebufferfv,
             &glClearNamedFramebufferuiv, &glDispatchCompute, &glDrawArrays, &glDrawArraysIndirect,
             &glDrawArraysInstanced, &glDrawArraysInstancedBaseInstance, &glDrawElementsBaseVertex,
             &glDrawElementsInstancedBaseVertexBaseInstance, &glGenerateTextureMipmap,
             &glInvalidateNamedFramebufferData, &glMultiDrawElementsIndirect>();
    take_all<CallKind::bind, &glBindBuffer, &glBindBufferBase, &glBindBufferRange, &glBindBuffersBase,
             &glBindFramebuffer, &glBindImageTexture, &glBindSampler, &glBindSamplers, &glBindTextureUnit,
             &glBindTextures, &glBindVertexArray, &glUniform1i, &glUniform2i, &glUniform4f, &glUseProgram>();
    take_all<CallKind::state, &glBlendFunc, &glBlendFunci, &glClipControl, &glColorMask, &glCullFace,
             &glDepthFunc, &glDepthMask, &glDisable, &glEnable, &glFrontFace, &glLineWidth, &glPixelStorei,
             &glPointSize, &glScissor, &glViewport>();
    take_all<CallKind::transfer, &glCompressedTextureSubImage2D, &glCopyImageSubData,
             &glCopyNamedBufferSubData, &glGetTextureImage, &glMapNamedBufferRange, &glNamedBufferSubData,
             &glTextureSubImage2D, &glUnmapNamedBuffer>();
    take_all<CallKind::object, &glAttachShader, &glCheckNamedFramebufferStatus, &glCompileShader,
             &glCreateBuffers, &glCreateFramebuffers, &glCreateProgram, &glCreateQueries, &glCreateSamplers,
             &glCreateShader, &glCreateTextures, &glCreateVertexArrays, &glDeleteBuffers,
             &glDeleteFramebuffers, &glDeleteProgram, &glDeleteQueries, &glDeleteSamplers, &glDeleteShader,
             &glDeleteTextures, &glDeleteVertexArrays, &glDetachShader, &glEnableVertexArrayAttrib,
             &glGetInteger64v, &glGetProgramInfoLog, &glGetProgramiv, &glGetShaderInfoLog, &glGetShaderiv,
             &glGetString, &glLinkProgram, &glNamedBufferStorage, &glNamedFramebufferDrawBuffers,
             &glNamedFramebufferTexture, &glSamplerParameteri, &glShaderSource, &glTextureParameteriv,
             &glTextureStorage2D, &glTextureStorage3D, &glVertexArrayAttribBinding,
             &glVertexArrayAttribFormat, &glVertexArrayAttribIFormat, &glVertexArrayElementBuffer,
             &glVertexArrayVertexBuffer>();
    take_all<CallKind::query, &glBeginQuery, &glDebugMessageCallback, &glDebugMessageControl, &glDeleteSync,
             &glEndConditionalRender, &glEndQuery, &glFenceSync, &glFlush, &glMemoryBarrier, &glObjectLabel,
             &glPopDebugGroup, &glPushDebugGroup, &glQueryCounter, &glTextureBarrier>();
    // Conditional rendering waits for its query: the GPU does, or the driver of a rasteriser on the CPU.
    take_all<CallKind::wait, &glBeginConditionalRender, &glFinish, &glGetQueryObjectui64v>();
    take_all<CallKind::pace, &glClientWaitSync>();
}

UncountedCalls::UncountedCalls() {
    ++g_depth;
}

UncountedCalls::~UncountedCalls() {
    --g_depth;
}

CallCounts calls() {
    return g_counts;
}

}  // namespace rambla::render::gl
