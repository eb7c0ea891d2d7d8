// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"
#include "sound/output/sound_placement.h"

namespace tactooth {

/// Positions of the sound sources in the tooth frame (+z to the crown, +y buccal), mm. The bur sounds at its tip, the
/// spray on the floor of the mouth below the crown, the suction behind the tooth, across from the dentist. `mesialX`:
/// direction of mesial along x, 1 or -1. `listener`: pose of the eye.
[[nodiscard]] SoundPlacement soundPlacementAt(const Box3& tooth, double mesialX, const Vec3& burTip,
                                              const Pose& listener);

}  // namespace tactooth
