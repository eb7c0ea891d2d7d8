// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/export_checker.h"
#include "tooth/random_cutting.h"

namespace tactooth::test {

/// What the judge says of the file of a surface.
[[nodiscard]] ExportCheck judged(const TriangleMesh& mesh);

struct OracleCutting {
    unsigned seed = 1;
    int strokes = 20;
    int check = 4;               ///< strokes from one look of the judge to the next
    double voxel = 0.05;         ///< mm
    double leastRemoved = 0.05;  ///< share of the whole that has to go, or little was tried
};

/// Cuts at random and expects that each time that the judge looks, what is written is closed, oriented, 2-manifold and
/// bounds a volume, which is the one that the moves have left, and crosses itself hardly anywhere.
void expectValidThroughout(TriangleMesh outer, const OracleCutting& cutting);

/// The same without the judge, far faster: cuts, and expects that what is left is closed and that all cut lines fitted
/// together.
void expectClosedAfter(TriangleMesh outer, const OracleCutting& cutting);

}  // namespace tactooth::test
