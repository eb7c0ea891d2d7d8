// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/gl_objects.h"

#include "view/gl/messages.h"

namespace tactooth::gl {

namespace {

const char* nameOf(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "invalid enumerant";
        case GL_INVALID_VALUE:
            return "invalid value";
        case GL_INVALID_OPERATION:
            return "invalid operation";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "invalid framebuffer operation";
        case GL_OUT_OF_MEMORY:
            return "out of memory";
        default:
            return "unknown error";
    }
}

/// The pixel transfer format that matches an internal format. OpenGL 4.1 requires one even without pixels.
std::pair<GLenum, GLenum> transferFormat(GLenum internalFormat) {
    switch (internalFormat) {
        case GL_DEPTH_COMPONENT24:
            return {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT};
        case GL_DEPTH24_STENCIL8:
            return {GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8};
        case GL_R8:
            return {GL_RED, GL_UNSIGNED_BYTE};
        default:
            return {GL_RGBA, GL_UNSIGNED_BYTE};
    }
}

}  // namespace

Expected<void> checkErrors(const Message& doing) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return {};
    // A lost context reports an error at every query, so only a bounded number of errors is cleared.
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
    }
    return unexpected(msg::kOpenGlError, nameOf(error), doing);
}

void allocateTexture(const Texture& texture, GLenum internalFormat, int width, int height, GLenum filter) {
    glBindTexture(GL_TEXTURE_2D, texture.name());
    const auto [format, type] = transferFormat(internalFormat);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), width, height, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void bindTexture(int unit, GLenum kind, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(kind, texture);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace tactooth::gl
