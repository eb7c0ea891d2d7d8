// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/brick_sweep.h"

#include <cmath>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// Lattice steps. How far beyond an edge the normal of its crossing may be sampled.
constexpr double kBeyondEdge = 0.05;

}  // namespace

BrickSweep::BrickSweep(const BrickKey& key, const Lattice& lattice, const std::vector<SweepStep>& steps, double reach)
    : corner_(lattice.corner(key)), spacing_(lattice.spacing()) {
    TACTOOTH_ASSERT(!steps.empty());
    TACTOOTH_ASSERT(std::isfinite(reach) && reach >= 0);
    if (steps.size() == 1) {  // each block queries it by itself
        steps_.push_back(&steps.front());
        return;
    }
    // One query at the last step. No earlier step is nearer than that, less the travel in between.
    double bound = steps.back().lowerBound(lattice.centre(key)) - lattice.halfDiagonal() - reach;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        if (step != steps.rbegin()) bound -= step->travel();
        if (bound < 0) steps_.push_back(&*step);
    }
}

const std::vector<SweepLanes>& BrickSweep::nearNodes(int block, double reach) {
    return near(block, kBlockSide - 1, 0, reach);
}

const std::vector<SweepLanes>& BrickSweep::nearEdges(int block) { return near(block, kBlockSide, kBeyondEdge, 0); }

/// For a block's cube. `side` and `beyond` count in steps of the lattice.
const std::vector<SweepLanes>& BrickSweep::near(int block, double side, double beyond, double reach) {
    TACTOOTH_ASSERT(block >= 0 && block < kBlocks);
    TACTOOTH_ASSERT(side > 0 && beyond >= 0 && !std::isnan(reach));
    near_.clear();
    near_.reserve(steps_.size());
    const Vec3 first = corner_ + kBlockSide * spacing_ * Vec3(block & 1, block >> 1 & 1, block >> 2);
    const Vec3 middle = first + Vec3::Constant(0.5 * side * spacing_);
    const double toCorner = (0.5 * side * std::sqrt(3.0) + beyond) * spacing_;
    for (const SweepStep* step : steps_) {
        const SweepStep::MidpointQuery query = step->queryFrom(middle);
        if (step->lowerBound(query) < toCorner + reach) near_.emplace_back(*step, first, spacing_, side, beyond, query);
    }
    return near_;
}

}  // namespace tactooth
