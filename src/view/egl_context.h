// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/expected.h"

namespace tactooth {

/// An OpenGL 4.1 core context with no surface, current on the thread that made it as long as it lives.
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

}  // namespace tactooth
