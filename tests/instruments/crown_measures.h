// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// How far the crown of a built-in tooth is from measured ones. A measured tooth is first stretched along its axes to
// the diameters of the built-in one, which has those of the textbooks.
#pragma once

#include <optional>

#include "instruments/builtin_tooth.h"

namespace tactooth::test {

struct CrownDeviation {
    double mirrorCorrelation = 1;          ///< of the occlusal relief, on a front tooth of the lingual one
    double section = 0;                    ///< mm, largest deviation of a diameter of a section
    double outline = 0;                    ///< mm, largest deviation of a harmonic of the outline from above
    std::optional<double> tips = {};       ///< mm, largest distance of a cusp's tip from its place, back teeth only
    std::optional<double> table = {};      ///< mm, largest deviation of a height of ridges, grooves and pits
    std::optional<double> edge = {};       ///< mm, largest deviation of the edge's height or place, front teeth only
    std::optional<double> thickness = {};  ///< mm, root mean square over the midline profile, front teeth only
};

/// The average tooth with +x mesial, as the measured tables.
[[nodiscard]] TriangleMesh mesialFrame(const BuiltinTooth& tooth);

/// `tooth` is the average one of the right side; third molars have no tables, only a correlation.
[[nodiscard]] CrownDeviation deviationOf(const BuiltinTooth& tooth);

}  // namespace tactooth::test
