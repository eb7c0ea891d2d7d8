// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/bvh/aabb_tree.h"

namespace tactooth {

/// Makes trees without some of a tree's triangles: the leaves and nodes that lose one are replaced by tighter ones,
/// those that lose all are gone, and the rest is shared. What a cut has taken away then costs a walk nothing, and a new
/// tree costs no more than what is replaced in it: the rim of what is gone, however much that is.
class MaskedBvh {
public:
    /// `whole` is a tree from which nothing was taken.
    explicit MaskedBvh(const AabbTree& whole);

    /// Takes a triangle out, or puts it back.
    void setHidden(std::uint32_t triangle, bool hidden);

    /// Puts all of them back.
    void showAll();

    /// The tree of the triangles that are not hidden.
    [[nodiscard]] AabbTree maskedTree() const;

private:
    /// A child of a node: its number times kWidth, plus the child's place.
    using Slot = std::uint32_t;
    static constexpr Slot kNoSlot = 0xffffffffU;

    /// How much of a leaf or of what hangs on a node is hidden.
    enum class HiddenState : std::uint8_t { None, Some, All };
    [[nodiscard]] HiddenState hiddenOfLeaf(std::uint32_t leaf) const;
    [[nodiscard]] HiddenState hiddenOfNode(std::uint32_t node) const;
    void setChild(Slot slot, HiddenState hides);

    /// What has become of a leaf or node of which something is left: where the tree that is made has it, and its box.
    struct Kept {
        AabbTree::Link link;
        float low[3], high[3];
    };
    [[nodiscard]] Kept keepNode(std::uint32_t node, AabbTree& tree) const;
    [[nodiscard]] Kept keepLeaf(std::uint32_t leaf, AabbTree& tree) const;
    [[nodiscard]] Kept keepChild(const AabbTree::Node& node, std::uint32_t number, int child, AabbTree& tree) const;

    AabbTree fullTree_;
    std::vector<std::uint32_t> laneOf_;  // of a triangle: its leaf times kWidth, plus its lane
    std::vector<Slot> aboveNode_;        // of a node; the root has none
    std::vector<Slot> aboveLeaf_;
    std::vector<std::uint8_t> hiddenLanes_;  // of a leaf: one bit each
    std::vector<std::uint8_t> children_;     // of a node: one bit for each that there is ...
    std::vector<std::uint8_t> someHidden_;   // ... that hides something
    std::vector<std::uint8_t> allHidden_;    // ... that hides all
    std::size_t replacedLeaves_ = 0;         // that hide something, but not all
    std::size_t replacedNodes_ = 0;
};

}  // namespace tactooth
