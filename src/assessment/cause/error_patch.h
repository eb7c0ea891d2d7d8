// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "assessment/preparation/preparation.h"
#include "geometry/util/message.h"

namespace tactooth {

/// A connected part of a surface that lies too far from the other one: of the cut surface where too much was removed,
/// of the ideal one where too little was.
struct ErrorPatch {
    bool isOver = true;           ///< too much was removed
    std::vector<Facet> facets;    ///< in the order of the surface's triangles
    double depth = 0;             ///< greatest distance, mm
    double volume = 0;            ///< sum of area times distance, mm^3
    Vec3 place = Vec3::Zero();    ///< where the distance is greatest, mm
    Vec3 normal = Vec3::UnitZ();  ///< mean, unit, out of the remaining tooth
};

/// Each kind with the largest volume first.
struct ErrorPatches {
    std::vector<ErrorPatch> over, under;
};

/// The parts that lie farther from the ideal surface than the tolerance; where nothing does, those that lie farther
/// from it than half of the greatest distance. Patches of less than 0.005 mm^3 are left out.
[[nodiscard]] ErrorPatches errorPatches(const Preparation& preparation, const CutSurfaces& surfaces);

/// What part of the preparation a patch belongs to: "Buccal wall".
[[nodiscard]] const MessageText& wallName(const ErrorPatch& patch, const DentalDirections& to, bool isCrown);

}  // namespace tactooth
