// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/sound_sources.h"

namespace tactooth {

SoundPlacement soundPlacementAt(const Box3& tooth, double mesialX, const Vec3& burTip, const Pose& listener) {
    constexpr double kBelow = 10;                  // mm: water gathers at the height of the roots
    constexpr double kDistal = 20, kLingual = 20;  // mm: clear of bur and mirror
    const Vec3 middle = tooth.center();
    return {.source = burTip,
            .listenerInWorld = listener,
            .mouth = middle - Vec3(0, 0, kBelow),
            .suction = middle - Vec3(kDistal * mesialX, kLingual, 0)};
}

}  // namespace tactooth
