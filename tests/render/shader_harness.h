#pragma once

#include <glm/glm.hpp>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "render/gl/buffer.h"
#include "render/gl/context.h"
#include "render/gl/program.h"
#include "render/shader_source.h"

namespace rambla::tests {

using Inputs = std::vector<glm::vec4>;

struct Random {
    std::mt19937 engine{11};
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> uniform{0.0f, 1.0f};

    glm::vec3 direction() {
        return glm::normalize(glm::vec3{normal(engine), normal(engine), normal(engine)});
    }
    float operator()() { return uniform(engine); }
};

inline void add(Inputs& inputs, glm::vec4 a, glm::vec4 b = {}, glm::vec4 c = {}, glm::vec4 d = {}) {
    inputs.insert(inputs.end(), {a, b, c, d});
}

/// Runs functions of the real shader library on the GPU over arrays of inputs.
class ShaderHarness {
public:
    static constexpr int k_inputs_per_item = 4;  ///< vec4s, named a, b, c, d in the expression

    /// @param include     a file under render/shaders
    /// @param statements  GLSL that computes `vec4 result` from `vec4 a, b, c, d`
    /// @param inputs      k_inputs_per_item vectors per item
    /// @param functions   GLSL that the include leaves to its includer
    [[nodiscard]] std::vector<glm::vec4> run(const std::string& include, const std::string& statements,
                                             std::span<const glm::vec4> inputs,
                                             const std::string& functions = "") {
        const std::string text =
            "#include \"" + include + "\"\n" + functions +
            "layout(local_size_x = 64) in;\n"
            "layout(std430, binding = 8) readonly buffer InputBlock { vec4 inputs[]; };\n"
            "layout(std430, binding = 9) writeonly buffer OutputBlock { vec4 outputs[]; };\n"
            "void main() {\n"
            "    uint item = gl_GlobalInvocationID.x;\n"
            "    if (item >= uint(outputs.length())) return;\n"
            "    vec4 a = inputs[4u * item], b = inputs[4u * item + 1u];\n"
            "    vec4 c = inputs[4u * item + 2u], d = inputs[4u * item + 3u];\n"
            "    vec4 result = vec4(0.0);\n" +
            statements + "\n    outputs[item] = result;\n}\n";
        render::gl::ProgramRegistry programs{[&](const std::string& path) {
            return path == "harness.comp.glsl" ? text : render::embedded_shader(path);
        }};
        const render::gl::Program& program = programs.get(
            {.name = "harness", .vertex = {}, .fragment = {}, .compute = "harness.comp.glsl", .defines = {}});

        const std::size_t items = inputs.size() / k_inputs_per_item;
        const render::gl::Buffer input{"inputs", inputs.size_bytes(), inputs.data()};
        const render::gl::Buffer output{"outputs", items * sizeof(glm::vec4)};
        input.range().bind(GL_SHADER_STORAGE_BUFFER, 8);
        output.range().bind(GL_SHADER_STORAGE_BUFFER, 9);
        program.use();
        glDispatchCompute(static_cast<GLuint>((items + 63) / 64), 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        std::vector<glm::vec4> result(items);
        glGetNamedBufferSubData(output.name(), 0, static_cast<GLsizeiptr>(items * sizeof(glm::vec4)),
                                result.data());
        context_.check_errors();
        return result;
    }

private:
    render::gl::Context context_{{}, true};
};

}  // namespace rambla::tests
