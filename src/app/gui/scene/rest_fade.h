// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <functional>
#include <optional>

#include "view/passes/cross_fade.h"

namespace tactooth {

/// Share of the full-quality picture `ms` after it was drawn: from 0 to 1, where it stays.
[[nodiscard]] double restFadeShare(double ms);

/// Lets the full-quality picture of a scene at rest take the place of the last picture of motion gradually. Its calls
/// with a framebuffer (OpenGL name) need the current context of that framebuffer.
class RestFade {
public:
    /// `redraw`: is called when `draw` should be called next.
    explicit RestFade(std::function<void()> redraw);
    /// Call it before the full-quality picture is drawn over the last one in `framebuffer`.
    [[nodiscard]] Expected<void> prepare(unsigned framebuffer, ImageSize size);
    /// Call it when that is drawn: from now on `framebuffer` shows a mixture of both.
    [[nodiscard]] Expected<void> start(unsigned framebuffer);
    /// Whether it does not yet show the full-quality picture.
    [[nodiscard]] bool isRunning() const { return since_.isValid(); }
    /// Draws what is due now, if it runs. Its last picture is the full-quality one.
    void draw(unsigned framebuffer);
    /// Something moves.
    void stop();
    /// Stops, and frees what belongs to the context.
    void forget();

private:
    [[nodiscard]] double share() const;

    std::optional<CrossFade> pictures_;  // made when it is needed first
    QTimer next_;
    QElapsedTimer since_;  // valid while it runs
};

}  // namespace tactooth
