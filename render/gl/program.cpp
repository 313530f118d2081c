#include "render/gl/program.h"

#include <array>
#include <functional>

#include "render/gl/shader_text.h"

namespace rambla::render::gl {

namespace {

struct DeleteShader {
    static void destroy(GLuint name) { glDeleteShader(name); }
};
using Shader = Object<DeleteShader>;

struct Stage {
    GLenum kind = 0;
    ShaderText text;
};

std::vector<Stage> expand_stages(const ProgramDesc& desc, const ShaderSource& source) {
    const std::array<std::pair<GLenum, const std::string*>, 3> files{{{GL_VERTEX_SHADER, &desc.vertex},
                                                                      {GL_FRAGMENT_SHADER, &desc.fragment},
                                                                      {GL_COMPUTE_SHADER, &desc.compute}}};
    std::vector<Stage> stages;
    for (const auto& [kind, path] : files) {
        if (!path->empty()) stages.push_back({kind, expand_shader(*path, source, desc.defines)});
    }
    return stages;
}

std::size_t hash_of(const std::vector<Stage>& stages) {
    std::string all;
    for (const Stage& stage : stages)
        all += stage.text.text;
    return std::hash<std::string>{}(all);
}

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    return log;
}

std::string program_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    return log;
}

Shader compile(const Stage& stage, const std::string& program) {
    Shader shader{glCreateShader(stage.kind)};
    label(GL_SHADER, shader.name(), program + ": " + stage.text.files[1]);
    const GLchar* text = stage.text.text.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) {
        throw ShaderError("program " + program + ":\n" +
                          map_shader_log(shader_log(shader.name()), stage.text));
    }
    return shader;
}

Object<DeleteProgram> link(const std::vector<Stage>& stages, const std::string& name) {
    Object<DeleteProgram> program{glCreateProgram()};
    std::vector<Shader> shaders;
    for (const Stage& stage : stages) {
        shaders.push_back(compile(stage, name));
        glAttachShader(program.name(), shaders.back().name());
    }
    glLinkProgram(program.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) {
        std::string files;
        for (const Stage& stage : stages)
            files += (files.empty() ? "" : ", ") + stage.text.files[1];
        throw ShaderError("program " + name + " (" + files + ") does not link:\n" +
                          program_log(program.name()));
    }
    for (const Shader& shader : shaders)
        glDetachShader(program.name(), shader.name());
    label(GL_PROGRAM, program.name(), name);
    return program;
}

}  // namespace

ProgramRegistry::ProgramRegistry(ShaderSource source)
    : source_{source ? std::move(source) : ShaderSource{embedded_shader}} {}

const Program& ProgramRegistry::get(const ProgramDesc& desc) {
    for (const auto& program : programs_) {
        if (program->desc() == desc) return *program;
    }
    auto program = std::make_unique<Program>();
    program->desc_ = desc;
    const std::vector<Stage> stages = expand_stages(desc, source_);
    program->text_hash_ = hash_of(stages);
    program->object_ = link(stages, desc.name);
    programs_.push_back(std::move(program));
    return *programs_.back();
}

std::string ProgramRegistry::reload() {
    std::string errors;
    for (const auto& program : programs_) {
        try {
            const std::vector<Stage> stages = expand_stages(program->desc(), source_);
            const std::size_t hash = hash_of(stages);
            if (hash == program->text_hash_) continue;
            program->object_ = link(stages, program->desc().name);
            program->text_hash_ = hash;
        } catch (const ShaderError& error) {
            errors += (errors.empty() ? "" : "\n") + std::string{error.what()};
        }
    }
    return errors;
}

std::vector<const Program*> ProgramRegistry::list() const {
    std::vector<const Program*> all;
    all.reserve(programs_.size());
    for (const auto& program : programs_)
        all.push_back(program.get());
    return all;
}

}  // namespace rambla::render::gl
