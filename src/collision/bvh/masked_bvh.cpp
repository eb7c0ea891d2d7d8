// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/masked_bvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

// A new version of the tree copies the path from the root to what has changed, and shares the rest: J. R. Driscoll et
// al., "Making Data Structures Persistent", J. Computer and System Sciences 38, 1989, "path copying". Differs from the
// paper: every version is made from the first one, so no version keeps another alive.

namespace tactooth {
namespace {

constexpr std::uint32_t kWidth = AabbTree::kWidth;
constexpr std::size_t kGrain = 4096;  // nodes or leaves that make a task of some 20 us

bool isPresent(const AabbTree::Node& node, int child) { return node.low[0][child] <= node.high[0][child]; }

/// A node without children: every box is inverted and infinite.
AabbTree::Node emptyNode() {
    AabbTree::Node node{};
    std::fill_n(&node.low[0][0], 3 * kWidth, std::numeric_limits<float>::infinity());
    std::fill_n(&node.high[0][0], 3 * kWidth, -std::numeric_limits<float>::infinity());
    return node;
}

}  // namespace

MaskedBvh::MaskedBvh(const AabbTree& whole)
    : fullTree_(whole),
      aboveNode_(whole.wholeNodes_, kNoSlot),
      aboveLeaf_(whole.wholeLeaves_),
      hiddenLanes_(whole.wholeLeaves_),
      children_(whole.wholeNodes_),
      someHidden_(whole.wholeNodes_),
      allHidden_(whole.wholeNodes_) {
    TACTOOTH_ASSERT(whole.nodes_.empty());
    if (whole.empty()) return;
    std::size_t triangles = 0;
    for (const AabbTree::Leaf& leaf : whole.leaves()) triangles += leaf.count;
    TACTOOTH_ASSERT(triangles < kNoSlot);
    laneOf_.resize(triangles);
    const auto noteLeaf = [&](std::size_t i) {
        const AabbTree::Leaf& leaf = whole.leaves()[i];
        for (std::uint32_t lane = 0; lane < leaf.count; ++lane)
            laneOf_[leaf.triangle[lane]] = static_cast<std::uint32_t>(i) * kWidth + lane;
    };
    parallelFor(whole.wholeLeaves_, noteLeaf, kGrain);
    const auto noteNode = [&](std::size_t i) {
        const AabbTree::Node& node = whole.wholeNode_[i];
        for (std::uint32_t child = 0; child < kWidth && isPresent(node, static_cast<int>(child)); ++child) {
            std::vector<Slot>& above = node.child[child].isLeaf() ? aboveLeaf_ : aboveNode_;
            above[node.child[child].index()] = static_cast<std::uint32_t>(i) * kWidth + child;
            children_[i] |= static_cast<std::uint8_t>(1U << child);
        }
    };
    parallelFor(whole.wholeNodes_, noteNode, kGrain);
}

MaskedBvh::HiddenState MaskedBvh::hiddenOfLeaf(std::uint32_t leaf) const {
    if (hiddenLanes_[leaf] == 0) return HiddenState::None;
    return hiddenLanes_[leaf] == (1U << fullTree_.wholeLeaf_[leaf].count) - 1U ? HiddenState::All : HiddenState::Some;
}

MaskedBvh::HiddenState MaskedBvh::hiddenOfNode(std::uint32_t node) const {
    if (someHidden_[node] == 0) return HiddenState::None;
    return allHidden_[node] == children_[node] ? HiddenState::All : HiddenState::Some;
}

void MaskedBvh::setChild(Slot slot, HiddenState hides) {
    TACTOOTH_ASSERT(slot / kWidth < someHidden_.size());
    const auto set = [&](std::uint8_t& mask, bool value) {
        const unsigned bit = 1U << slot % kWidth;
        mask = static_cast<std::uint8_t>(value ? mask | bit : mask & ~bit);
    };
    set(someHidden_[slot / kWidth], hides != HiddenState::None);
    set(allHidden_[slot / kWidth], hides == HiddenState::All);
}

void MaskedBvh::setHidden(std::uint32_t triangle, bool hidden) {
    TACTOOTH_ASSERT(triangle < laneOf_.size());
    const std::uint32_t leaf = laneOf_[triangle] / kWidth;
    const std::uint32_t lane = laneOf_[triangle] % kWidth;
    if (((hiddenLanes_[leaf] >> lane) & 1U) == static_cast<unsigned>(hidden)) return;
    const auto count = [](std::size_t& replaced, HiddenState before, HiddenState now) {
        replaced +=
            static_cast<std::size_t>(now == HiddenState::Some) - static_cast<std::size_t>(before == HiddenState::Some);
    };
    HiddenState before = hiddenOfLeaf(leaf);
    hiddenLanes_[leaf] ^= static_cast<std::uint8_t>(1U << lane);
    HiddenState now = hiddenOfLeaf(leaf);
    count(replacedLeaves_, before, now);
    for (Slot above = aboveLeaf_[leaf]; now != before && above != kNoSlot;) {
        const std::uint32_t node = above / kWidth;
        const HiddenState child = now;
        before = hiddenOfNode(node);
        setChild(above, child);
        now = hiddenOfNode(node);
        count(replacedNodes_, before, now);
        above = aboveNode_[node];
    }
    TACTOOTH_ASSERT(replacedLeaves_ <= hiddenLanes_.size());
    TACTOOTH_ASSERT(replacedNodes_ <= someHidden_.size());
}

void MaskedBvh::showAll() {
    std::ranges::fill(hiddenLanes_, std::uint8_t{0});
    std::ranges::fill(someHidden_, std::uint8_t{0});
    std::ranges::fill(allHidden_, std::uint8_t{0});
    replacedLeaves_ = replacedNodes_ = 0;
}

MaskedBvh::Kept MaskedBvh::keepLeaf(std::uint32_t number, AabbTree& tree) const {
    const AabbTree::Leaf& from = fullTree_.wholeLeaf_[number];
    std::uint32_t left = ((1U << from.count) - 1U) & ~std::uint32_t{hiddenLanes_[number]};
    TACTOOTH_ASSERT(left != 0);
    AabbTree::Leaf& leaf = tree.leaves_.emplace_back();
    leaf.count = static_cast<std::uint32_t>(std::popcount(left));
    const int first = std::countr_zero(left);
    std::array<int, kWidth> source;
    for (std::uint32_t lane = 0; lane < kWidth; ++lane, left &= left - 1) {
        source[lane] = left != 0 ? std::countr_zero(left) : first;
        leaf.triangle[lane] = from.triangle[source[lane]];
    }
    for (int corner = 0; corner < 3; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto& of = from.corner[corner][axis];
            for (std::uint32_t lane = 0; lane < kWidth; ++lane) leaf.corner[corner][axis][lane] = of[source[lane]];
        }
    }
    Kept kept{
        AabbTree::Link::toLeaf(fullTree_.wholeLeaves_ + static_cast<std::uint32_t>(tree.leaves_.size()) - 1), {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        const Float8 a = Float8::load(leaf.corner[0][axis]);
        const Float8 b = Float8::load(leaf.corner[1][axis]);
        const Float8 c = Float8::load(leaf.corner[2][axis]);
        kept.low[axis] = lowest(min(min(a, b), c));
        kept.high[axis] = highest(max(max(a, b), c));
    }
    return kept;
}

MaskedBvh::Kept MaskedBvh::keepChild(const AabbTree::Node& node, std::uint32_t number, int child,
                                     AabbTree& tree) const {
    const AabbTree::Link link = node.child[child];
    if (((someHidden_[number] >> child) & 1U) != 0)
        return link.isLeaf() ? keepLeaf(link.index(), tree) : keepNode(link.index(), tree);
    Kept kept{link, {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        kept.low[axis] = node.low[axis][child];
        kept.high[axis] = node.high[axis][child];
    }
    return kept;
}

MaskedBvh::Kept MaskedBvh::keepNode(std::uint32_t number, AabbTree& tree) const {
    const AabbTree::Node& from = fullTree_.wholeNode_[number];
    AabbTree::Node node = emptyNode();
    int count = 0;
    for (int child = 0; child < AabbTree::kWidth && isPresent(from, child); ++child) {
        if (((allHidden_[number] >> child) & 1U) != 0) continue;
        const Kept kept = keepChild(from, number, child, tree);
        for (int axis = 0; axis < 3; ++axis) {
            node.low[axis][count] = kept.low[axis];
            node.high[axis][count] = kept.high[axis];
            node.centre[axis][count] = from.centre[axis][child];  // the disc encloses the rest as well
            node.normal[axis][count] = from.normal[axis][child];
        }
        node.halfThickness[count] = from.halfThickness[child];
        node.discRadius[count] = from.discRadius[child];
        node.child[count++] = kept.link;
    }
    TACTOOTH_ASSERT(count > 0);
    Kept whole{{}, {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        whole.low[axis] = lowest(Float8::load(node.low[axis]));
        whole.high[axis] = highest(Float8::load(node.high[axis]));
    }
    whole.link = AabbTree::Link::toNode(fullTree_.wholeNodes_ + static_cast<std::uint32_t>(tree.nodes_.size()));
    tree.nodes_.push_back(node);
    return whole;
}

AabbTree MaskedBvh::maskedTree() const {
    AabbTree tree = fullTree_;
    if (fullTree_.empty() || someHidden_[fullTree_.root_.index()] == 0) return tree;
    tree.box_.setEmpty();
    if (hiddenOfNode(fullTree_.root_.index()) == HiddenState::All) return tree;
    tree.nodes_.reserve(replacedNodes_);
    tree.leaves_.reserve(replacedLeaves_);
    const Kept root = keepNode(fullTree_.root_.index(), tree);
    TACTOOTH_ASSERT(tree.nodes_.size() == replacedNodes_ && tree.leaves_.size() == replacedLeaves_);
    tree.root_ = root.link;
    for (const float* corner : {root.low, root.high}) tree.box_.extend(Vec3(corner[0], corner[1], corner[2]));
    return tree;
}

void MaskedBvh::validate() const {
    std::size_t leaves = 0, nodes = 0;
    for (std::uint32_t leaf = 0; leaf < hiddenLanes_.size(); ++leaf) {
        TACTOOTH_ASSERT(hiddenLanes_[leaf] >> fullTree_.wholeLeaf_[leaf].count == 0);
        leaves += hiddenOfLeaf(leaf) == HiddenState::Some ? 1 : 0;
    }
    for (std::uint32_t node = 0; node < someHidden_.size(); ++node) {
        TACTOOTH_ASSERT((allHidden_[node] & ~someHidden_[node]) == 0);
        TACTOOTH_ASSERT((someHidden_[node] & ~children_[node]) == 0);
        nodes += hiddenOfNode(node) == HiddenState::Some ? 1 : 0;
        for (int child = 0; child < AabbTree::kWidth; ++child) {
            if (((children_[node] >> child) & 1U) == 0) continue;
            const AabbTree::Link link = fullTree_.wholeNode_[node].child[child];
            const HiddenState state = link.isLeaf() ? hiddenOfLeaf(link.index()) : hiddenOfNode(link.index());
            TACTOOTH_ASSERT((((someHidden_[node] >> child) & 1U) != 0) == (state != HiddenState::None));
            TACTOOTH_ASSERT((((allHidden_[node] >> child) & 1U) != 0) == (state == HiddenState::All));
        }
    }
    TACTOOTH_ASSERT(leaves == replacedLeaves_);
    TACTOOTH_ASSERT(nodes == replacedNodes_);
    for (std::uint32_t triangle = 0; triangle < laneOf_.size(); ++triangle) {
        const std::uint32_t lane = laneOf_[triangle] % kWidth;
        TACTOOTH_ASSERT(fullTree_.wholeLeaf_[laneOf_[triangle] / kWidth].triangle[lane] == triangle);
    }
}

}  // namespace tactooth
