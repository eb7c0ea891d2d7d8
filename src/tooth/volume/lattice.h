// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/util/assert.h"
#include "geometry/util/vec.h"
#include "tooth/volume/brick.h"
#include "tooth/volume/brick_key.h"

namespace tactooth {

/// A node, by its coordinates in the whole lattice.
struct LatticeNode {
    explicit LatticeNode(const Eigen::Vector3i& number)  // eight nodes a side
        : key{number.x() >> 3, number.y() >> 3, number.z() >> 3},
          node(nodeIndex(number.x() & 7, number.y() & 7, number.z() & 7)) {}

    BrickKey key;
    int node;  ///< nodeIndex in the brick
};

/// The lattice of nodes with its spacing in mm: node (i, j, k) is at origin + spacing * (i, j, k).
class Lattice {
public:
    explicit Lattice(double spacing) : spacing_(spacing) { TACTOOTH_ASSERT(std::isfinite(spacing) && spacing > 0); }

    [[nodiscard]] double spacing() const { return spacing_; }
    [[nodiscard]] Vec3 node(int i, int j, int k) const {
        // Not on the round numbers of flat faces of modelled shapes: a node on a face would have no defined side.
        return spacing_ * Vec3(i + 0.371, j + 0.443, k + 0.517);
    }
    /// The point of a node by its position in or beside a brick. The bits are the same from each brick.
    [[nodiscard]] Vec3 node(const BrickKey& key, const std::array<int, 3>& place) const {
        return node(kBrickSide * key.x + place[0], kBrickSide * key.y + place[1], kBrickSide * key.z + place[2]);
    }
    /// Point of the first node of a brick.
    [[nodiscard]] Vec3 corner(const BrickKey& key) const {
        return node(kBrickSide * key.x, kBrickSide * key.y, kBrickSide * key.z);
    }
    /// Middle of a brick's nodes.
    [[nodiscard]] Vec3 centre(const BrickKey& key) const {
        return corner(key) + Vec3::Constant(0.5 * (kBrickSide - 1) * spacing_);
    }
    /// Distance from the centre of a brick to its corner nodes, mm.
    [[nodiscard]] double halfDiagonal() const { return 0.5 * (kBrickSide - 1) * spacing_ * std::sqrt(3.0); }
    /// The brick whose nodes, and the cells that begin at them, hold `point`.
    [[nodiscard]] BrickKey brickAt(const Vec3& point) const {
        TACTOOTH_ASSERT(point.allFinite());
        const Vec3 place = (point - node(0, 0, 0)) / (kBrickSide * spacing_);
        TACTOOTH_ASSERT(place.cwiseAbs().maxCoeff() < std::numeric_limits<int>::max());
        return {static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y())),
                static_cast<int>(std::floor(place.z()))};
    }
    /// Every brick that owns a node or a cell within `box`, in ascending order. The box is not empty.
    [[nodiscard]] std::vector<BrickKey> bricksTouching(const Box3& box) const {
        TACTOOTH_ASSERT(!box.isEmpty());
        const BrickKey low = brickAt(box.min());
        const BrickKey high = brickAt(box.max());
        std::vector<BrickKey> keys;
        for (int x = low.x; x <= high.x; ++x) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int z = low.z; z <= high.z; ++z) keys.push_back({x, y, z});
            }
        }
        return keys;
    }

private:
    double spacing_;
};

}  // namespace tactooth
