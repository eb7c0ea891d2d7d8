// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/aabb_tree.h"

namespace tactooth {

/// Makes trees without some of a tree's triangles: the leaves and nodes that lose one are replaced by tighter ones,
/// those that lose all are gone, and the rest is shared. What a cut has taken away then costs a walk nothing, and a new
/// tree costs no more than what is replaced in it.
class TreeThinner {
public:
    /// `whole` is a tree from which nothing was taken.
    explicit TreeThinner(const AabbTree& whole);

    /// Takes a triangle out, or puts it back.
    void setHidden(std::uint32_t triangle, bool hidden);

    /// Puts all of them back.
    void showAll();

    /// The tree of the triangles that are not hidden.
    [[nodiscard]] AabbTree thinned() const;

private:
    /// A child of a node: its number times kWidth, plus the child's place.
    using Slot = std::uint32_t;
    static constexpr Slot kNoSlot = 0xffffffffU;

    /// What has become of a leaf or node: where the tree that is made has it, and its box.
    struct Kept {
        AabbTree::Link link;
        float low[3], high[3];
    };
    [[nodiscard]] std::optional<Kept> keepNode(std::uint32_t node, AabbTree& tree) const;
    [[nodiscard]] std::optional<Kept> keepLeaf(std::uint32_t leaf, AabbTree& tree) const;
    [[nodiscard]] std::optional<Kept> keepChild(const AabbTree::Node& node, std::uint32_t number, int child,
                                                AabbTree& tree) const;

    AabbTree whole_;
    std::vector<std::uint32_t> laneOf_;  // of a triangle: its leaf times kWidth, plus its lane
    std::vector<Slot> aboveNode_;        // of a node; the root has none
    std::vector<Slot> aboveLeaf_;
    std::vector<std::uint8_t> hiddenLanes_;  // of a leaf: one bit each
    std::vector<std::uint8_t> touched_;      // of a node: one bit for each child that hides something
    std::size_t touchedLeafCount_ = 0;       // that hide something
    std::size_t touchedNodeCount_ = 0;
};

}  // namespace tactooth
