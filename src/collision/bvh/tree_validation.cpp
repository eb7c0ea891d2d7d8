// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include "collision/bvh/aabb_tree.h"

namespace tactooth {
namespace {

constexpr float kTolerance = 1e-5F;  // of a coordinate: rounding of the disc

bool isPresent(const AabbTree::Node& node, int child) { return node.low[0][child] <= node.high[0][child]; }

/// Visits a sub-tree, and asserts that boxes and discs of a node enclose the corners below it.
class TreeValidation {
public:
    explicit TreeValidation(const AabbTree& tree) : tree_(tree) {}

    /// Asserts the invariants of the sub-tree, and appends its corners.
    void visit(AabbTree::Link link, int depth, std::vector<Vec3f>& corners) {
        TACTOOTH_ASSERT(depth <= AabbTree::kMaxDepth);
        if (link.isLeaf()) return visitLeaf(tree_.leaf(link), corners);
        const AabbTree::Node& node = tree_.node(link);
        bool hasEnded = false;
        TACTOOTH_ASSERT(isPresent(node, 0));
        for (int child = 0; child < AabbTree::kWidth; ++child) {
            if (!isPresent(node, child)) {
                hasEnded = true;
                continue;
            }
            TACTOOTH_ASSERT(!hasEnded);  // a traversal does not see children behind an absent one
            std::vector<Vec3f> below;
            visit(node.child[child], depth + 1, below);
            for (const Vec3f& corner : below) expectEnclosed(node, child, corner);
            corners.insert(corners.end(), below.begin(), below.end());
        }
    }

private:
    static void visitLeaf(const AabbTree::Leaf& leaf, std::vector<Vec3f>& corners) {
        TACTOOTH_ASSERT(leaf.count >= 1 && leaf.count <= AabbTree::kWidth);
        for (std::uint32_t lane = 0; lane < AabbTree::kWidth; ++lane) {
            TACTOOTH_ASSERT(lane < leaf.count || leaf.triangle[lane] == leaf.triangle[0]);
            for (const auto& corner : leaf.corner)
                corners.emplace_back(corner[0][lane], corner[1][lane], corner[2][lane]);
        }
    }

    static void expectEnclosed(const AabbTree::Node& node, int child, const Vec3f& corner) {
        for (int axis = 0; axis < 3; ++axis) {
            TACTOOTH_ASSERT(node.low[axis][child] <= corner[axis]);
            TACTOOTH_ASSERT(corner[axis] <= node.high[axis][child]);
        }
        const Vec3f centre(node.centre[0][child], node.centre[1][child], node.centre[2][child]);
        const Vec3f normal(node.normal[0][child], node.normal[1][child], node.normal[2][child]);
        const Vec3f away = corner - centre;
        const float slack = kTolerance * (1 + centre.cwiseAbs().maxCoeff() + away.norm());
        const bool isBall = normal.isZero(0);
        TACTOOTH_ASSERT(isBall || std::abs(normal.norm() - 1) < kTolerance);
        TACTOOTH_ASSERT(isBall || std::abs(normal.dot(away)) <= node.halfThickness[child] + slack);
        TACTOOTH_ASSERT((isBall ? away : normal.cross(away)).norm() <= node.discRadius[child] + slack);
    }

    const AabbTree& tree_;
};

}  // namespace

void AabbTree::validate() const {
    if (empty()) return;
    TACTOOTH_ASSERT(whole_ != nullptr);
    TACTOOTH_ASSERT(wholeNode_ == whole_->nodes.data() && wholeNodes_ == whole_->nodes.size());
    TACTOOTH_ASSERT(wholeLeaf_ == whole_->leaves.data() && wholeLeaves_ == whole_->leaves.size());
    std::vector<Vec3f> corners;
    TreeValidation(*this).visit(root_, 0, corners);
    for (const Vec3f& corner : corners) TACTOOTH_ASSERT(box_.contains(corner.cast<double>()));
}

}  // namespace tactooth
