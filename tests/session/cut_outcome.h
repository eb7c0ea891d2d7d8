// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "assessment/mesh_deviation.h"
#include "session/simulation/cut_model.h"

// What a cut has left, to hold two ways of telling the same path against each other.
namespace tactooth::test {

struct CutOutcome {
    double removed;  // mm^3
    TriangleMesh surface;

    explicit CutOutcome(CutModel& piece)
        : removed(total(piece.removed())), surface(visibleMesh(*piece.surface()).mesh) {}
};

/// The same but for half a per cent of the volume and five micrometres of the surface at its worst place.
inline void expectSame(const CutOutcome& one, const CutOutcome& other) {
    constexpr double kSameVolume = 0.005;   // of it
    constexpr double kSameSurface = 0.005;  // mm
    ASSERT_GT(one.removed, 1e-3);
    EXPECT_NEAR(other.removed, one.removed, kSameVolume * one.removed);
    EXPECT_LE(hausdorffDistance(one.surface, other.surface), kSameSurface);
}

}  // namespace tactooth::test
