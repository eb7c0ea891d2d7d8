// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "collision/bvh/mesh_deviation.h"
#include "session/simulation/cut_model.h"

// The result of a cut, to compare two samplings of the same path.
namespace tactooth::test {

struct CutOutcome {
    double removed;  // mm^3
    TriangleMesh surface;

    explicit CutOutcome(CutModel& piece)
        : removed(total(piece.removed())), surface(visibleMesh(*piece.surface()).mesh) {}
};

/// Equal within 0.5 % of the volume and 5 um of the surface.
inline void expectSame(const CutOutcome& one, const CutOutcome& other) {
    constexpr double kSameVolume = 0.005;   // of it
    constexpr double kSameSurface = 0.005;  // mm
    ASSERT_GT(one.removed, 1e-3);
    EXPECT_NEAR(other.removed, one.removed, kSameVolume * one.removed);
    EXPECT_LE(hausdorffDistance(one.surface, other.surface), kSameSurface);
}

}  // namespace tactooth::test
