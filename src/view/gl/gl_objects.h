// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <utility>

#include "geometry/util/expected.h"

namespace tactooth::gl {

/// Owns one OpenGL object; movable, not copyable. Its context must be current when it is made and destroyed.
template <class Kind>
class Object {
public:
    Object() = default;
    [[nodiscard]] static Object make() { return Object(Kind::create()); }
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Object() {
        if (name_ != 0) Kind::destroy(name_);
    }

    [[nodiscard]] GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    explicit Object(GLuint name) : name_(name) {}
    GLuint name_ = 0;
};

struct BufferKind {
    static GLuint create() {
        GLuint name = 0;
        return glGenBuffers(1, &name), name;
    }
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayKind {
    static GLuint create() {
        GLuint name = 0;
        return glGenVertexArrays(1, &name), name;
    }
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct TextureKind {
    static GLuint create() {
        GLuint name = 0;
        return glGenTextures(1, &name), name;
    }
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct SamplerKind {
    static GLuint create() {
        GLuint name = 0;
        return glGenSamplers(1, &name), name;
    }
    static void destroy(GLuint name) { glDeleteSamplers(1, &name); }
};
struct RenderbufferKind {
    static GLuint create() {
        GLuint name = 0;
        return glGenRenderbuffers(1, &name), name;
    }
    static void destroy(GLuint name) { glDeleteRenderbuffers(1, &name); }
};
struct FramebufferKind {
    static GLuint create() {
        GLuint name = 0;
        return glGenFramebuffers(1, &name), name;
    }
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct ProgramKind {
    static GLuint create() { return glCreateProgram(); }
    static void destroy(GLuint name) { glDeleteProgram(name); }
};

using Buffer = Object<BufferKind>;
using VertexArray = Object<VertexArrayKind>;
using Texture = Object<TextureKind>;
using Sampler = Object<SamplerKind>;
using Renderbuffer = Object<RenderbufferKind>;
using Framebuffer = Object<FramebufferKind>;
using Program = Object<ProgramKind>;

/// Fails with a sentence if OpenGL has reported an error since the last call. `doing` completes "while ...".
[[nodiscard]] Expected<void> checkErrors(const Message& doing);

/// Binds `texture` as the 2-D texture of the current unit and allocates one level, clamped, with this filter.
void allocateTexture(const Texture& texture, GLenum internalFormat, int width, int height, GLenum filter);

/// Binds a texture of this kind (GL_TEXTURE_2D ...) to a unit, then makes the first unit active again.
void bindTexture(int unit, GLenum kind, GLuint texture);

}  // namespace tactooth::gl
