// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace tactooth {

/// Of two recordings in the plots: orange and blue, which the colour-blind can distinguish, too. The ghost of the other
/// one is blue as well.
inline constexpr QColor kFirstRecordingColour(213, 94, 0), kOtherRecordingColour(0, 114, 178);

}  // namespace tactooth
