// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "geometry/util/expected.h"

namespace tactooth {

/// An OpenGL 4.1 core context with no surface, current on the thread that made it as long as it lives. Of a graphics
/// card, if one is there and LIBGL_ALWAYS_SOFTWARE does not forbid it.
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

/// What draws in the current context, as the driver names itself.
[[nodiscard]] std::string rendererName();

/// Whether `rendererName` is one that draws by the processor.
[[nodiscard]] bool isSoftwareRenderer(std::string_view rendererName);

}  // namespace tactooth
