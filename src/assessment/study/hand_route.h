// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "assessment/study/hand_habits.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// One place of the route of a hand.
struct HandStation {
    Vec3 tip;                ///< of the bur, tooth frame, mm
    bool isInTooth = false;  ///< the path to it goes through the tooth; false: the hand lifts the bur, or travels
};

/// What a hand works on.
struct HandTask {
    std::vector<std::vector<Vec3>> paths;     ///< of the bur's tip through the ideal preparation, tooth frame, mm
    std::vector<std::vector<double>> depths;  ///< of each place below the uncut surface along the shaft, mm
    Vec3 outward = Vec3::UnitZ();             ///< direction of the shaft, unit
};

/// The route of a bur through a preparation in layers, from above; between two paths it is lifted. The habits `layer`,
/// `deeper`, `wider`, `undone` and `uneven` shape it; `seed` says where it strays to.
[[nodiscard]] std::vector<HandStation> routeOf(const HandTask& task, const HandHabits& habits, std::uint64_t seed);

}  // namespace tactooth
