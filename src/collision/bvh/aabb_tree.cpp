// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/aabb_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "collision/bvh/binned_sah.h"
#include "collision/bvh/hilbert_order.h"
#include "collision/narrow/round_up.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

// Binned surface-area heuristic: I. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE
// Symposium on Interactive Ray Tracing 2007, section 3. Differs from the paper: a node has eight children, found by
// repeatedly splitting the child of the largest area. A leaf is one packet of eight triangles, so the split cost counts
// packets, not triangles.

namespace tactooth {
namespace {

constexpr int kBalancedDepth = 8;  // deeper nodes split at the median: bounds the depth for any input

struct Child {
    TreeRange range;
    TreeBounds bounds;
    float halfArea = 0;
};

/// A node whose place in memory is not known yet.
struct BuildNode {
    int count = 0;
    std::array<Child, AabbTree::kWidth> children;
    std::array<std::unique_ptr<BuildNode>, AabbTree::kWidth> inner;  // null: the child is a leaf
    std::uint32_t nodes = 1, leaves = 0;                             // of the sub-tree
};

/// The child to split next: the largest that is not a leaf yet, or -1. Largest by area, or with `balanced` by number of
/// triangles, which bounds the depth.
int widestChild(const BuildNode& node, bool balanced) {
    int widest = -1;
    float width = -1.0F;
    for (int i = 0; i < node.count; ++i) {
        const Child& child = node.children[i];
        if (child.range.size() <= AabbTree::kWidth) continue;
        const float candidate = balanced ? static_cast<float>(child.range.size()) : child.halfArea;
        if (candidate > width) width = candidate, widest = i;
    }
    return widest;
}

void divide(BuildNode& node, bool balanced) {
    while (node.count < AabbTree::kWidth) {
        const int widest = widestChild(node, balanced);
        if (widest < 0) break;
        const TreeRange whole = node.children[widest].range;
        const TreeSplit split = splitRange(whole, balanced);
        node.children[widest] = {whole.first(split.leftCount), split.left, split.left.halfArea()};
        node.children[node.count++] = {whole.after(split.leftCount), split.right, split.right.halfArea()};
    }
}

/// Calls function(i) for i from 0 to count - 1, in parallel if there are many items below.
template <class Function>
void forChildren(int count, std::size_t items, const Function& function) {
    if (items > kParallelTreeRange) return parallelFor(static_cast<std::size_t>(count), function);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) function(i);
}

std::unique_ptr<BuildNode> buildBest(const Child& all, int depth) {
    auto node = std::make_unique<BuildNode>();
    node->children[0] = all;
    node->count = 1;
    divide(*node, depth > kBalancedDepth);
    forChildren(node->count, all.range.size(), [&](std::size_t i) {
        if (node->children[i].range.size() > AabbTree::kWidth) node->inner[i] = buildBest(node->children[i], depth + 1);
    });
    for (int i = 0; i < node->count; ++i) {
        node->nodes += node->inner[i] ? node->inner[i]->nodes : 0;
        node->leaves += node->inner[i] ? node->inner[i]->leaves : 1;
    }
    return node;
}

/// Makes leaves of the items in their order. All nodes but the last are full.
std::unique_ptr<BuildNode> buildInOrder(const TreeRange& all) {
    std::size_t most = AabbTree::kWidth;  // items below a child
    while (most * AabbTree::kWidth < all.size()) most *= AabbTree::kWidth;
    auto node = std::make_unique<BuildNode>();
    for (std::size_t begin = 0; begin < all.size(); begin += most) {
        std::unique_ptr<BuildNode>& inner = node->inner[node->count];
        Child& child = node->children[node->count++];
        child.range = all.after(begin).first(std::min(most, all.size() - begin));
        if (child.range.size() > AabbTree::kWidth) {
            inner = buildInOrder(child.range);
            for (int i = 0; i < inner->count; ++i) child.bounds.extend(inner->children[i].bounds);
        } else {
            child.bounds = boundsOf(child.range);
        }
        node->nodes += inner ? inner->nodes : 0;
        node->leaves += inner ? inner->leaves : 1;
    }
    return node;
}

std::unique_ptr<BuildNode> buildQuickly(const TreeRange& all) {
    sortByHilbertIndex(all);
    return buildInOrder(all);
}

void fillLeaf(AabbTree::Leaf& leaf, const TriangleMesh& mesh, std::span<const TreeItem> items) {
    TACTOOTH_ASSERT(!items.empty() && items.size() <= AabbTree::kWidth);
    leaf.count = static_cast<std::uint32_t>(items.size());
    std::array<const Triangle*, AabbTree::kWidth> corners;  // collected first, so that the memory accesses overlap
    for (std::size_t lane = 0; lane < AabbTree::kWidth; ++lane) {
        leaf.triangle[lane] = items[lane < items.size() ? lane : 0].triangle();
        corners[lane] = &mesh.triangles[leaf.triangle[lane]];
    }
    for (int corner = 0; corner < 3; ++corner) {
        for (std::size_t lane = 0; lane < AabbTree::kWidth; ++lane) {
            const Vec3f& point = mesh.vertices[(*corners[lane])[corner]];
            for (int axis = 0; axis < 3; ++axis) leaf.corner[corner][axis][lane] = point[axis];
        }
    }
}

constexpr std::uint32_t kMaxLeavesOfDisc = 512;  // a larger sub-tree is not flat

/// The mean normal of leaves: the direction of the sum of their triangles' area vectors. A nearly flat surface is
/// thinnest along it. Zero if there is none.
Vec3f meanNormal(std::span<const AabbTree::Leaf> leaves) {
    Vec3x8 area = Vec3x8::all(0, 0, 0);
    for (const AabbTree::Leaf& leaf : leaves) {
        const Vec3x8 a = Vec3x8::load(leaf.corner[0]);
        area = area + cross(Vec3x8::load(leaf.corner[1]) - a, Vec3x8::load(leaf.corner[2]) - a);
    }
    float lanes[3][AabbTree::kWidth];
    area.store(lanes);
    Vec3f sum = Vec3f::Zero();
    for (int i = 0; i < AabbTree::kWidth; ++i) sum += Vec3f(lanes[0][i], lanes[1][i], lanes[2][i]);
    const float length = sum.norm();
    return length > 0 ? Vec3f(sum / length) : Vec3f(Vec3f::Zero());
}

/// Encloses the leaves of a child in a disc. If there are many leaves: in a ball around the child's box.
void encloseInDisc(std::span<const AabbTree::Leaf> leaves, AabbTree::Node& node, int child) {
    Vec3f low, high;
    for (int axis = 0; axis < 3; ++axis) low[axis] = node.low[axis][child], high[axis] = node.high[axis][child];
    Vec3f centre = (low + high) / 2;
    Vec3f normal = Vec3f::Zero();
    float halfThickness = 0, discRadius = (high - low).norm() / 2;
    if (leaves.size() <= kMaxLeavesOfDisc) {
        normal = meanNormal(leaves);
        const Vec3x8 n = Vec3x8::all(normal.x(), normal.y(), normal.z());
        const Vec3x8 c = Vec3x8::all(centre.x(), centre.y(), centre.z());
        Float8 bottom = Float8::all(std::numeric_limits<float>::infinity());
        Float8 top = Float8::all(-std::numeric_limits<float>::infinity());
        Float8 squared = Float8::all(0);
        for (const AabbTree::Leaf& leaf : leaves) {
            for (const auto& corner : leaf.corner) {
                const Vec3x8 away = Vec3x8::load(corner) - c;
                const Vec3x8 across = normal.isZero(0) ? away : cross(n, away);
                const Float8 reach = dot(n, away);
                bottom = min(bottom, reach);
                top = max(top, reach);
                squared = max(squared, dot(across, across));
            }
        }
        halfThickness = (highest(top) - lowest(bottom)) / 2;
        discRadius = std::sqrt(highest(squared));
        centre += (highest(top) + lowest(bottom)) / 2 * normal;
    }
    for (int axis = 0; axis < 3; ++axis) {
        node.centre[axis][child] = centre[axis];
        node.normal[axis][child] = normal[axis];
    }
    node.halfThickness[child] = kRoundUp * halfThickness;
    node.discRadius[child] = kRoundUp * discRadius;
}

/// Writes a tree into memory in depth-first order: a child is close to its parent.
class Layout {
public:
    Layout(const TriangleMesh& mesh, AabbTree::Node* nodes, AabbTree::Leaf* leaves)
        : mesh_(mesh), nodes_(nodes), leaves_(leaves) {}

    /// Writes a sub-tree; `node` and `leaf` are its first indices.
    void write(const BuildNode& from, std::uint32_t node, std::uint32_t leaf) const {
        TACTOOTH_ASSERT(from.count >= 1 && from.count <= AabbTree::kWidth);
        AabbTree::Node& to = nodes_[node];
        std::array<std::uint32_t, AabbTree::kWidth> nodeAt{}, leafAt{};
        std::uint32_t nextNode = node + 1;
        for (int i = 0; i < AabbTree::kWidth; ++i) {
            const auto [low, high] = from.children[i].bounds.box();
            for (int axis = 0; axis < 3; ++axis) to.low[axis][i] = low[axis], to.high[axis][i] = high[axis];
            nodeAt[i] = nextNode, leafAt[i] = leaf;
            to.child[i] = from.inner[i] ? AabbTree::Link::toNode(nextNode) : AabbTree::Link::toLeaf(leaf);
            nextNode += from.inner[i] ? from.inner[i]->nodes : 0;
            leaf += from.inner[i] ? from.inner[i]->leaves : 1;
        }
        forChildren(from.count, std::size_t{from.leaves} * AabbTree::kWidth, [&](std::size_t i) {
            if (from.inner[i]) return write(*from.inner[i], nodeAt[i], leafAt[i]);
            fillLeaf(leaves_[leafAt[i]], mesh_, from.children[i].range.items);
        });
        for (int i = 0; i < AabbTree::kWidth; ++i) {
            to.halfThickness[i] = to.discRadius[i] = 0;
            for (int axis = 0; axis < 3; ++axis) to.centre[axis][i] = to.normal[axis][i] = 0;
            if (i < from.count) encloseInDisc({leaves_ + leafAt[i], from.inner[i] ? from.inner[i]->leaves : 1}, to, i);
        }
    }

private:
    const TriangleMesh& mesh_;
    AabbTree::Node* nodes_;
    AabbTree::Leaf* leaves_;
};

}  // namespace

AabbTree::AabbTree(const TriangleMesh& mesh, TreeBuild build) {
    if (mesh.empty()) return;
    const std::size_t count = mesh.triangles.size();
    TACTOOTH_ASSERT(count < (std::size_t{1} << 31));
    LargeVector<TreeItem> items(count);
    LargeVector<std::uint8_t> bins(count);
    const auto enclose = [&](std::size_t i) {
        const auto& [a, b, c] = mesh.triangles[i];
        items[i] = TreeItem(static_cast<std::uint32_t>(i), mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    };
    parallelFor(count, enclose, kParallelTreeRange);
    const TreeRange all{items, bins};
    const TreeBounds whole = boundsOf(all);
    const std::unique_ptr<BuildNode> tree =
        build == TreeBuild::Best ? buildBest({all, whole, whole.halfArea()}, 0) : buildQuickly(all);
    const auto arrays = std::make_shared<Arrays>();
    arrays->nodes.resize(wholeNodes_ = tree->nodes);
    arrays->leaves.resize(wholeLeaves_ = tree->leaves);
    Layout(mesh, arrays->nodes.data(), arrays->leaves.data()).write(*tree, 0, 0);
    wholeNode_ = arrays->nodes.data();
    wholeLeaf_ = arrays->leaves.data();
    whole_ = arrays;
    const auto [low, high] = whole.box();
    box_ = Box3(Vec3f(low).cast<double>(), Vec3f(high).cast<double>());
    TACTOOTH_ASSERT(wholeLeaves_ >= (count + kWidth - 1) / kWidth && wholeLeaves_ <= count);
    TACTOOTH_ASSERT(!box_.isEmpty());
}

}  // namespace tactooth
