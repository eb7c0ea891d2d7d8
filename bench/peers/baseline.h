// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth::bench {

/// A way to find out how a bur stands in a tooth, ready to be asked.
class Baseline {
public:
    virtual ~Baseline() = default;
    [[nodiscard]] virtual std::string name() const = 0;
    /// What the answer holds: "depth", "yes or no".
    [[nodiscard]] virtual std::string gives() const = 0;
    /// One tick: the hand holds the bur at this pose. Returns whether the bur touches the tooth.
    virtual bool tick(const Pose& deviceInTooth) = 0;
};

using Peers = std::vector<std::unique_ptr<Baseline>>;

/// What all peers are given.
struct Pair {
    const TriangleMesh& tooth;
    const TriangleMesh& bur;
    const TriangleMesh& burHull;  ///< the bur's convex hull, for those that take nothing else
};

/// Each adds its ways, if the library was found when this was configured.
void addFclPeers(const Pair& pair, Peers& peers);
void addBulletPeers(const Pair& pair, Peers& peers);

[[nodiscard]] TriangleMesh convexHull(const TriangleMesh& mesh);

}  // namespace tactooth::bench
