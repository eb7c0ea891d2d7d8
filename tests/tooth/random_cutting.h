// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tooth/file/exported_mesh.h"
#include "tooth/surface/incremental_surface.h"

namespace tactooth::test {

/// A tooth that is cut by seeded random strokes. They cover difficult cases: all angles and places, paths through the
/// whole tooth, thin walls, detached pieces, and planes of the lattice's nodes.
class RandomCutting {
public:
    /// `burs`: catalogue numbers. `voxel` in mm.
    RandomCutting(TriangleMesh outer, double voxel, const std::vector<std::string>& burs, unsigned seed);

    void stroke();
    /// Removes all detached pieces and debris. Returns the number of pieces.
    std::size_t removeDetached();
    /// Calls `check` after each move of the next strokes. A stroke has some tens of moves.
    void checkAfterEachMove(std::function<void()> check) { check_ = std::move(check); }

    /// The mesh that the tool touches ...
    [[nodiscard]] TriangleMesh mesh() const { return visibleMesh(*surface_.snapshot()).mesh; }
    /// ... and the mesh of the files.
    [[nodiscard]] TriangleMesh exported() const {
        return exportedMesh(*surface_.snapshot(), volume_.lattice().spacing()).mesh;
    }
    /// See IncrementalSurface::failures.
    [[nodiscard]] std::size_t failures() const { return surface_.failures(); }
    /// Sum over the moves, mm^3.
    [[nodiscard]] double removed() const { return removed_; }
    /// Volume of the uncut tooth, mm^3.
    [[nodiscard]] double whole() const { return whole_; }

private:
    [[nodiscard]] double unit() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
    [[nodiscard]] Vec3 direction();
    [[nodiscard]] Vec3 placeInside();
    void move(const RevolutionEnvelope& bur, const Pose& from, const Pose& to, double longestStep);
    void anywhere(const RevolutionEnvelope& bur);
    void through(const RevolutionEnvelope& bur);
    void thinWall(const RevolutionEnvelope& bur);
    void detachedBit(const RevolutionEnvelope& bur);
    void alongNodes(const RevolutionEnvelope& bur);

    CutVolume volume_;
    IncrementalSurface surface_;
    std::vector<RevolutionEnvelope> burs_;
    Box3 box_;
    std::mt19937 random_;
    double whole_;
    double removed_ = 0;
    std::function<void()> check_;
};

}  // namespace tactooth::test
