// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <algorithm>

namespace tactooth {

/// A time of a recording, s, as "3:07.25". A time before its start is shown as the start.
[[nodiscard]] inline QString clockText(double time) {
    const auto hundredths = static_cast<qlonglong>(std::max(0.0, time) * 100);
    return QString("%1:%2.%3")
        .arg(hundredths / 6000)
        .arg(hundredths / 100 % 60, 2, 10, QChar('0'))
        .arg(hundredths % 100, 2, 10, QChar('0'));
}

}  // namespace tactooth
