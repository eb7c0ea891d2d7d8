// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "view/camera/camera.h"
#include "view/gl/gl_objects.h"

namespace tactooth {

/// A linked pair of shaders. Setting a uniform that the shaders do not use has no effect.
class ShaderProgram {
public:
    ShaderProgram() = default;
    /// Each stage is the concatenation of its sources, after `defines` ("#define X 1\n"). `name` appears in errors. An
    /// empty fragment stage writes only depth.
    [[nodiscard]] static Expected<ShaderProgram> create(const std::string& name, const std::string& defines,
                                                        std::initializer_list<std::string_view> vertex,
                                                        std::initializer_list<std::string_view> fragment);

    void use() const { glUseProgram(program_.name()); }
    /// These set uniforms of the program in use.
    void set(const char* uniform, int value) const { glUniform1i(location(uniform), value); }
    void set(const char* uniform, float value) const { glUniform1f(location(uniform), value); }
    void set(const char* uniform, const Eigen::Vector4f& value) const {
        glUniform4fv(location(uniform), 1, value.data());
    }
    void set(const char* uniform, const Mat4& value) const;
    void setAll(const char* uniform, const Eigen::Vector4f* values, int count) const {
        glUniform4fv(location(uniform), count, values->data());
    }
    void setAll(const char* uniform, const float* values, int count) const {
        glUniform1fv(location(uniform), count, values);
    }

private:
    [[nodiscard]] GLint location(const char* uniform) const { return glGetUniformLocation(program_.name(), uniform); }
    gl::Program program_;
};

/// The binding point of the shaders' `Frame` block.
inline constexpr GLuint kFrameBinding = 0;

}  // namespace tactooth
