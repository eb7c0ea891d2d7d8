// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "assessment/cavity_walls.h"
#include "session/simulation/surface_change.h"

namespace tactooth {

/// Metrics of a cavity against an ideal one. Volumes in mm^3.
struct CavityProgress {
    double planned = 0;             ///< the whole ideal cavity
    double cleared = 0;             ///< cut part of it
    double beyond = 0;              ///< cut outside of it
    double maxOverPreparation = 0;  ///< greatest distance of the cut beyond the ideal walls, mm

    /// 0..1.
    [[nodiscard]] double clearedFraction() const { return planned > 0 ? cleared / planned : 0; }
    /// Dice coefficient of the cavity and the ideal one, 0..1: twice the common volume over the sum of both (L. R.
    /// Dice, "Measures of the amount of ecologic association between species", Ecology 26, 1945).
    [[nodiscard]] double dice() const {
        const double both = planned + cleared + beyond;
        return both > 0 ? 2 * cleared / both : 0;
    }
};

/// Computes the metrics of a cavity while it is cut: compares the tooth with an ideal shape. It counts points of a
/// grid, 0.1 mm apart or somewhat more in a large cavity, which gives the volume to about 1 %.
class CavityMetrics {
public:
    /// `target`: the tooth with the ideal cavity, closed; `outer`: the uncut tooth, closed. Where the two are nearer to
    /// each other than kCavityDepth nothing is to be cut. Takes a second for a large tooth.
    CavityMetrics(std::shared_ptr<const SurfacePart> target, const SurfacePart& outer);
    /// The same; `walls` are those of the target in `outer`.
    CavityMetrics(std::shared_ptr<const SurfacePart> target, const SurfacePart& outer, const CavityWalls& walls);

    /// The metrics of `tooth`, a snapshot; `removed` is its removed volume, mm^3. Fast where `tooth` differs little
    /// from that of the last call. One thread at a time.
    [[nodiscard]] CavityProgress of(const Surface& tooth, double removed);

    /// Whether the target has nothing to cut.
    [[nodiscard]] bool empty() const { return points_.empty(); }

private:
    void takeCleared(const Surface& tooth);
    [[nodiscard]] double maxOverPreparationOf(const Surface& tooth);

    std::shared_ptr<const SurfacePart> target_;
    double pointVolume_ = 0;  // that each point stands for, mm^3
    std::vector<Vec3f> points_;
    std::vector<std::uint8_t> isCleared_;
    std::size_t cleared_ = 0;
    SurfaceChange change_;
    std::unordered_map<std::uint64_t, double> overPreparation_;  // beyond the target, by the id of a patch, mm
};

}  // namespace tactooth
