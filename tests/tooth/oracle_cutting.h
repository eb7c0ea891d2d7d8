// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/export_checker.h"
#include "tooth/random_cutting.h"

namespace tactooth::test {

/// Writes a surface to a file and checks the file by the oracle.
[[nodiscard]] ExportCheck checkExportOf(const TriangleMesh& mesh);

struct OracleCutting {
    unsigned seed = 1;
    int strokes = 20;
    int interval = 4;            ///< strokes between two checks by the oracle
    double voxel = 0.05;         ///< mm
    double leastRemoved = 0.05;  ///< fraction of the tooth that must be removed, so that the test covers enough
};

/// Cuts at random. At each check by the oracle the file must be closed, oriented, 2-manifold and bound a volume. The
/// volume must be the one that the moves have left. The surface may intersect itself hardly anywhere.
void expectValidThroughout(TriangleMesh outer, const OracleCutting& cutting);

/// The same without the oracle, and far faster. What is left must be closed, and all cut lines must have been
/// consistent.
void expectClosedAfter(TriangleMesh outer, const OracleCutting& cutting);

}  // namespace tactooth::test
