// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/bvh/aabb_tree.h"

namespace tactooth {

/// Makes trees without the hidden triangles of a tree. Leaves and nodes with some hidden triangles are replaced by
/// tighter ones, those with only hidden triangles are left out, and the rest is shared. So removed triangles cost a
/// query nothing. A new tree costs only its replaced leaves and nodes: those at the border of the hidden region.
class MaskedBvh {
public:
    /// `whole` is a tree without hidden triangles.
    explicit MaskedBvh(const AabbTree& whole);

    /// Hides a triangle, or shows it again.
    void setHidden(std::uint32_t triangle, bool hidden);

    /// Shows all triangles.
    void showAll();

    /// The tree of the triangles that are not hidden.
    [[nodiscard]] AabbTree maskedTree() const;

    /// Asserts every invariant, in O(n): masks and counts agree with the hidden triangles.
    void validate() const;

private:
    /// A child of a node: the node's index times kWidth, plus the number of the child.
    using Slot = std::uint32_t;
    static constexpr Slot kNoSlot = 0xffffffffU;

    /// How many triangles of a leaf or of a sub-tree are hidden.
    enum class HiddenState : std::uint8_t { None, Some, All };
    [[nodiscard]] HiddenState hiddenOfLeaf(std::uint32_t leaf) const;
    [[nodiscard]] HiddenState hiddenOfNode(std::uint32_t node) const;
    void setChild(Slot slot, HiddenState hides);

    /// A leaf or node of the new tree, with its box.
    struct Kept {
        AabbTree::Link link;
        float low[3], high[3];
    };
    [[nodiscard]] Kept keepNode(std::uint32_t node, AabbTree& tree) const;
    [[nodiscard]] Kept keepLeaf(std::uint32_t leaf, AabbTree& tree) const;
    [[nodiscard]] Kept keepChild(const AabbTree::Node& node, std::uint32_t number, int child, AabbTree& tree) const;

    AabbTree fullTree_;
    std::vector<std::uint32_t> laneOf_;  // of a triangle: the index of its leaf times kWidth, plus its lane
    std::vector<Slot> aboveNode_;        // parent of a node; the root has none
    std::vector<Slot> aboveLeaf_;
    std::vector<std::uint8_t> hiddenLanes_;  // of a leaf: one bit for each hidden triangle
    std::vector<std::uint8_t> children_;     // of a node: one bit for each child that is present ...
    std::vector<std::uint8_t> someHidden_;   // ... that has hidden triangles
    std::vector<std::uint8_t> allHidden_;    // ... whose triangles are all hidden
    std::size_t replacedLeaves_ = 0;         // leaves with some, but not all triangles hidden
    std::size_t replacedNodes_ = 0;
};

}  // namespace tactooth
