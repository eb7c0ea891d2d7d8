// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "collision/bvh/closest_point.h"

namespace tactooth {

/// The leaves of a surface's tree near one place, for many nearest-point queries around it. A brick makes 512 such
/// queries. A traversal of the tree for each would cost more than the tests of the triangles.
class LeafCache {
public:
    /// Collects all leaves with a triangle within `reach` (mm) of `centre`. `part` must outlive this.
    LeafCache(const SurfacePart& part, const Vec3& centre, double reach);

    [[nodiscard]] bool empty() const { return groups_.empty(); }

    /// Returns the result of `closestPoint`, bit for bit, if the ball of radius `within` around `query` lies inside the
    /// ball of the constructor.
    [[nodiscard]] std::optional<ClosestPoint> closest(const Vec3& query, double within) const;

private:
    /// Eight leaves with their boxes side by side. Unused entries are infinitely far away.
    struct alignas(32) Group {
        float low[3][8];
        float high[3][8];
        const AabbTree::Leaf* leaf[8];
    };
    void add(const AabbTree::Node& node, int child, const AabbTree::Leaf& leaf);

    std::vector<Group> groups_;
    int last_ = 8;  // number of leaves in the last group
};

}  // namespace tactooth
