// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"
#include "sound/output/sound_placement.h"

namespace tactooth {

/// Where things sound around a tooth, all in its frame (+z to the crown, +y buccal), mm: the bur at its tip, the spray
/// on the floor of the mouth below the crown, the suction where an assistant holds it, across from the dentist and
/// behind the tooth. `mesialX`: 1 where mesial is +x, -1 where it is -x. `listener`: the eye that sees the tooth.
[[nodiscard]] SoundPlacement soundPlacementAt(const Box3& tooth, double mesialX, const Vec3& burTip,
                                              const Pose& listener);

}  // namespace tactooth
