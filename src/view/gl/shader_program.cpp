// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/shader_program.h"

#include <vector>

#include "view/gl/messages.h"

namespace tactooth {

namespace {

constexpr std::string_view kVersion = "#version 410 core\n";

std::string joined(const std::string& defines, std::initializer_list<std::string_view> sources) {
    std::string all = std::string(kVersion) + defines;
    for (const std::string_view source : sources) all += source;
    return all;
}

std::string firstLine(const std::string& log) { return log.substr(0, log.find('\n')); }

Unexpected refusal(const std::string& name, const MessageText& what, const std::string& log) {
    return unexpected(msg::kShaderRefused, what, name, firstLine(log));
}

/// Compiles one stage and attaches it. The shader object is freed with the program.
Expected<void> attach(GLuint program, GLenum stage, const std::string& name, const std::string& source) {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return {};
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return refusal(name, msg::kCompile, log);
}

}  // namespace

Expected<ShaderProgram> ShaderProgram::create(const std::string& name, const std::string& defines,
                                              std::initializer_list<std::string_view> vertex,
                                              std::initializer_list<std::string_view> fragment) {
    ShaderProgram result;
    result.program_ = gl::Program::make();
    const GLuint program = result.program_.name();
    const auto vertexDone = attach(program, GL_VERTEX_SHADER, name, joined(defines, vertex));
    if (!vertexDone) return Unexpected{vertexDone.error()};
    const auto fragmentDone = attach(program, GL_FRAGMENT_SHADER, name, joined(defines, fragment));
    if (!fragmentDone) return Unexpected{fragmentDone.error()};
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        return refusal(name, msg::kLink, log);
    }
    const GLuint block = glGetUniformBlockIndex(program, "Frame");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, kFrameBinding);
    return result;
}

void ShaderProgram::set(const char* uniform, const Mat4& value) const {
    const Eigen::Matrix4f single = value.cast<float>();
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, single.data());
}

}  // namespace tactooth
