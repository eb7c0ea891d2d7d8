// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <optional>

namespace tactooth {

/// Work in the background for which somebody may wait, as the status line shows it.
struct LongWork {
    QString title;                      ///< what is done, for screen readers
    std::optional<double> share;        ///< that is done, 0..1; none: nobody knows
    std::function<void()> cancel = {};  ///< leaves everything as it was before; empty: it cannot be cancelled
    QString cancelTip = {};             ///< what cancelling means
};

}  // namespace tactooth
