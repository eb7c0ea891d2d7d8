// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "instruments/hand_instruments.h"
#include "instruments/spindle.h"

namespace tactooth {

/// Side view of the working end of a hand instrument, on a clear ground. The rings of a probe are black. Takes some
/// milliseconds.
[[nodiscard]] QImage drawHandInstrument(HandInstrument kind, QSize size);

/// Side view of the head of the handpiece of a drive, with a bur and with the ring by whose colour dentists know the
/// gear: red for a faster bur, blue for one as fast as the motor, none for a turbine. `handpiece`: its surface, tool
/// frame. Takes some tens of milliseconds.
[[nodiscard]] QImage drawHandpiece(const SpindlePreset& drive, const TriangleMesh& handpiece, QSize size);

}  // namespace tactooth
