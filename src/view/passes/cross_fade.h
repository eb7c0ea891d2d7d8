// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/util/expected.h"
#include "view/camera/camera.h"

namespace tactooth {

/// Two pictures of the same scene and what lies between them, so that one can take the place of the other without a
/// jump. Like Renderer, it belongs to the context in which it is made.
class CrossFade {
public:
    [[nodiscard]] static Expected<CrossFade> create();
    CrossFade(CrossFade&&) noexcept;
    CrossFade& operator=(CrossFade&&) noexcept;
    ~CrossFade();

    /// Keeps what framebuffer `shown` (OpenGL name) shows in its lower left `size` as the first picture.
    [[nodiscard]] Expected<void> keepFirst(unsigned shown, ImageSize size);
    /// Keeps what `shown` shows there now as the last picture.
    [[nodiscard]] Expected<void> keepLast(unsigned shown);
    /// Draws into framebuffer `target`, which stays bound, `share` (0..1) of the last picture and the rest of the first
    /// one; at 1 each pixel is that of the last picture.
    void draw(unsigned target, double share) const;

private:
    struct Parts;
    explicit CrossFade(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;  // the window includes this header, and its OpenGL header is another one
};

}  // namespace tactooth
