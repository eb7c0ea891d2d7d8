// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session/hands/instrument_poses.h"

namespace tactooth {

/// Where a right-handed dentist sits to work on a tooth, and how that tooth is seen from there.
struct ChairView {
    int clock = 0;        ///< position around the lying patient's head: 12 is behind it, 9 is on its right; 0: unknown
    bool mirror = false;  ///< the line of sight goes by the mouth mirror; the view is that line's last part
    ViewDirection view;   ///< tooth frame
};

/// The view of a tooth of the mouth (FDI, isPermanentTooth).
[[nodiscard]] ChairView chairView(int fdi);

}  // namespace tactooth
