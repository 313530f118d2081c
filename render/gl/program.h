#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/object.h"
#include "render/shader_source.h"

namespace rambla::render::gl {

struct DeleteProgram {
    static void destroy(GLuint name) { glDeleteProgram(name); }
};

/// A shader that cannot be read, compiled or linked. The message holds lines `file.glsl:12: what is wrong`.
class ShaderError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Which files make a program. Files are paths under render/shaders; either vertex and fragment, or compute.
/// A depth-only program has no fragment file.
struct ProgramDesc {
    std::string name;
    std::string vertex;
    std::string fragment;
    std::string compute;
    std::vector<std::pair<std::string, std::string>> defines;  ///< specialisation: `#define first second`

    bool operator==(const ProgramDesc&) const = default;
};

/// A linked program. Lives in its registry, which may replace the GL name on a reload: ask for name() at each
/// use, and set uniforms each time (better: fixed binding points in the shader and uniform blocks).
class Program {
public:
    [[nodiscard]] GLuint name() const { return object_.name(); }
    [[nodiscard]] const ProgramDesc& desc() const { return desc_; }
    void use() const { glUseProgram(name()); }

private:
    friend class ProgramRegistry;
    ProgramDesc desc_;
    std::size_t text_hash_ = 0;
    Object<DeleteProgram> object_;
};

/// All programs of a renderer. Passes ask for theirs when they first need them; what has been asked for
/// stays.
class ProgramRegistry {
public:
    explicit ProgramRegistry(ShaderSource source);
    ProgramRegistry(const ProgramRegistry&) = delete;
    ProgramRegistry& operator=(const ProgramRegistry&) = delete;

    /// The program of a description; compiled on first request. The reference stays valid as long as the
    /// registry.
    /// @throws ShaderError
    [[nodiscard]] const Program& get(const ProgramDesc& desc);

    /// Compiles again every program whose text has changed. One that fails keeps its old program.
    /// @return  messages of those that failed, empty when all is well
    [[nodiscard]] std::string reload();

    [[nodiscard]] std::vector<const Program*> list() const;

private:
    ShaderSource source_;
    std::vector<std::unique_ptr<Program>> programs_;
};

}  // namespace rambla::render::gl
