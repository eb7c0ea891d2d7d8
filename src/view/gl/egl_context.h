// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "geometry/util/expected.h"

namespace tactooth {

/// An OpenGL 4.1 core context without a surface. It is current on the thread that made it, as long as it exists. It
/// uses a graphics card if there is one and LIBGL_ALWAYS_SOFTWARE does not forbid it.
class EglContext {
public:
    [[nodiscard]] static Expected<EglContext> create();
    EglContext(EglContext&&) noexcept;
    EglContext& operator=(EglContext&&) noexcept;
    ~EglContext();

private:
    struct Handles;
    explicit EglContext(std::unique_ptr<Handles> handles);
    std::unique_ptr<Handles> handles_;
};

/// The driver's name for the renderer of the current context.
[[nodiscard]] std::string rendererName();

/// Whether `rendererName` is the name of a software renderer.
[[nodiscard]] bool isSoftwareRenderer(std::string_view rendererName);

}  // namespace tactooth
