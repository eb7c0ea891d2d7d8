// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "collision/narrow/simd8.h"
#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"
#include "geometry/util/large_pages.h"

namespace tactooth {

/// How a tree is built: for the fastest queries, or in the shortest time.
enum class TreeBuild { Best, Quick };

/// Bounding-volume hierarchy over the triangles of a mesh: nodes of eight children, leaves of up to eight triangles, in
/// depth-first order. Boxes are in single precision and enclose their triangles exactly (a mesh is in single precision
/// too). Built once; any number of threads may read it. A copy shares the memory.
class AabbTree {
public:
    static constexpr int kWidth = 8;

    /// The place of a child: a node or a leaf, by its index.
    class Link {
    public:
        static Link toNode(std::uint32_t index) { return Link(index); }
        static Link toLeaf(std::uint32_t index) { return Link(index | kLeafBit); }
        Link() = default;
        [[nodiscard]] bool isLeaf() const { return (bits_ & kLeafBit) != 0; }
        [[nodiscard]] std::uint32_t index() const { return bits_ & ~kLeafBit; }

    private:
        static constexpr std::uint32_t kLeafBit = 0x80000000U;
        explicit Link(std::uint32_t bits) : bits_(bits) {}
        std::uint32_t bits_ = 0;
    };

    /// Up to eight children: the box of each, axis by axis, and a disc around its triangles. An absent child has an
    /// inverted infinite box, which no query meets; absent children come last. A small piece of surface is nearly flat,
    /// so a disc across its mean normal is much smaller than its box.
    struct alignas(32) Node {
        float low[3][kWidth];
        float high[3][kWidth];
        Link child[kWidth];
        float centre[3][kWidth];      ///< of the disc, mm
        float normal[3][kWidth];      ///< unit, or zero where the disc is a ball
        float halfThickness[kWidth];  ///< of the disc along its normal, mm
        float discRadius[kWidth];     ///< of the disc across its normal, mm
    };

    /// Up to eight triangles, corner by corner and axis by axis. Unused lanes repeat the first triangle.
    struct alignas(32) Leaf {
        float corner[3][3][kWidth];
        std::uint32_t triangle[kWidth];
        std::uint32_t count;
    };

    AabbTree() = default;
    explicit AabbTree(const TriangleMesh& mesh, TreeBuild build = TreeBuild::Best);

    [[nodiscard]] bool empty() const { return box_.isEmpty(); }
    /// Where a traversal begins; not for an empty tree.
    [[nodiscard]] Link rootLink() const { return root_; }
    [[nodiscard]] const Node& root() const {
        TACTOOTH_ASSERT(!empty());
        return node(root_);
    }
    [[nodiscard]] const Node& node(Link link) const {
        const std::uint32_t i = link.index();
        TACTOOTH_ASSERT(!link.isLeaf());
        TACTOOTH_ASSERT(i < wholeNodes_ + nodes_.size());
        return i < wholeNodes_ ? wholeNode_[i] : nodes_[i - wholeNodes_];
    }
    [[nodiscard]] const Leaf& leaf(Link link) const {
        const std::uint32_t i = link.index();
        TACTOOTH_ASSERT(link.isLeaf());
        TACTOOTH_ASSERT(i < wholeLeaves_ + leaves_.size());
        return i < wholeLeaves_ ? wholeLeaf_[i] : leaves_[i - wholeLeaves_];
    }
    /// All leaves by index; of a tree without hidden triangles.
    [[nodiscard]] std::span<const Leaf> leaves() const { return {wholeLeaf_, wholeLeaves_}; }
    /// All nodes by index; of a tree without hidden triangles.
    [[nodiscard]] std::span<const Node> nodes() const { return {wholeNode_, wholeNodes_}; }
    /// Of all triangles, mm; empty for an empty tree.
    [[nodiscard]] const Box3& box() const { return box_; }
    /// Memory of nodes and leaves.
    [[nodiscard]] std::size_t bytes() const {
        return (wholeNodes_ + nodes_.size()) * sizeof(Node) + (wholeLeaves_ + leaves_.size()) * sizeof(Leaf);
    }

    /// Asserts every invariant, in O(n): each node and leaf is reached once, boxes and discs enclose their triangles,
    /// absent children come last, the depth is at most kMaxDepth.
    void validate() const;

    /// The greatest depth. A depth-first traversal needs a stack of (kWidth - 1) times this, plus one.
    static constexpr int kMaxDepth = 24;
    static constexpr int kStackSize = (kWidth - 1) * kMaxDepth + 1;

private:
    friend class MaskedBvh;
    struct Arrays {
        LargeVector<Node> nodes;
        LargeVector<Leaf> leaves;
    };

    std::shared_ptr<const Arrays> whole_;  // of the mesh, shared by all trees with hidden triangles
    const Node* wholeNode_ = nullptr;      // its nodes: saves a traversal one indirection
    const Leaf* wholeLeaf_ = nullptr;
    std::uint32_t wholeNodes_ = 0;
    std::uint32_t wholeLeaves_ = 0;
    std::vector<Node> nodes_;  // replace some of those; their indices begin at wholeNodes_
    std::vector<Leaf> leaves_;
    Link root_;
    Box3 box_;
};

}  // namespace tactooth
