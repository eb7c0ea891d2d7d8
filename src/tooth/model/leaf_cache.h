// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "collision/bvh/closest_point.h"

namespace tactooth {

/// The triangles of a surface near one place, for many questions about points around it: a brick asks for the nearest
/// point 512 times, and a walk down the tree for each would cost more than the triangles themselves.
class LeafCache {
public:
    /// Finds all that lies within `reach` (mm) of `centre`. `part` outlives this.
    LeafCache(const SurfacePart& part, const Vec3& centre, double reach);

    [[nodiscard]] bool empty() const { return groups_.empty(); }

    /// The same as `closestPoint`, bit for bit, wherever the ball of `within` around `query` lies in what was found.
    [[nodiscard]] std::optional<ClosestPoint> closest(const Vec3& query, double within) const;

private:
    /// Eight leaves of the tree with their boxes side by side; those that are not there are infinitely far.
    struct alignas(32) Group {
        float low[3][8];
        float high[3][8];
        const AabbTree::Leaf* leaf[8];
    };
    void add(const AabbTree::Node& node, int child, const AabbTree::Leaf& leaf);

    std::vector<Group> groups_;
    int last_ = 8;  // leaves in the last group
};

}  // namespace tactooth
