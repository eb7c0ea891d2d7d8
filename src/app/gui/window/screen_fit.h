// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMargins>
#include <QRect>
#include <algorithm>

namespace tactooth {

/// The place of a window, without its frame, that brings it with its frame into `room`, the free part of the screen. It
/// moves no farther than it must, and gets smaller only if the room is too small. `frame`: around the window.
[[nodiscard]] inline QRect fittedInto(const QRect& room, const QRect& window, const QMargins& frame) {
    const QRect inner = room.marginsRemoved(frame);
    const QSize size = window.size().boundedTo(inner.size());
    const QPoint place(std::clamp(window.left(), inner.left(), inner.left() + inner.width() - size.width()),
                       std::clamp(window.top(), inner.top(), inner.top() + inner.height() - size.height()));
    return {place, size};
}

}  // namespace tactooth
