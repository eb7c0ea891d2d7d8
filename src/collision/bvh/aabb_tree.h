// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "collision/narrow/simd8.h"
#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/large_pages.h"

namespace tactooth {

/// How a tree is built: for many walks, or to be there soon.
enum class TreeBuild { Best, Quick };

/// Bounding-volume hierarchy over the triangles of a mesh: nodes of eight children, leaves of up to eight triangles,
/// each stored side by side in the order in which a query walks over them. Boxes are single precision and hold their
/// triangles exactly (a mesh keeps single precision too). Built once, read by any number of threads; a copy shares the
/// memory.
class AabbTree {
public:
    static constexpr int kWidth = 8;

    /// Where a child of a node lives: another node, a leaf, or nowhere.
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

    /// The boxes of up to eight children, axis by axis. An absent child has an inverted infinite box, which no query
    /// touches. And a disc around what hangs on each: surfaces are flat where one looks closely, and fill far less of a
    /// disc across their mean normal than of a box.
    struct alignas(32) Node {
        float low[3][kWidth];
        float high[3][kWidth];
        Link child[kWidth];
        float centre[3][kWidth];      ///< of the disc
        float normal[3][kWidth];      ///< unit, or zero where the disc is a ball
        float halfThickness[kWidth];  ///< from the centre along the normal, either way, mm
        float discRadius[kWidth];     ///< from the centre across the normal, mm
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
    /// Where a walk begins; not for an empty tree.
    [[nodiscard]] Link rootLink() const { return root_; }
    [[nodiscard]] const Node& root() const { return node(root_); }
    [[nodiscard]] const Node& node(Link link) const {
        const std::uint32_t i = link.index();
        return i < wholeNodes_ ? wholeNode_[i] : nodes_[i - wholeNodes_];
    }
    [[nodiscard]] const Leaf& leaf(Link link) const {
        const std::uint32_t i = link.index();
        return i < wholeLeaves_ ? wholeLeaf_[i] : leaves_[i - wholeLeaves_];
    }
    /// All leaves by index, of a tree from which nothing was taken.
    [[nodiscard]] std::span<const Leaf> leaves() const { return {wholeLeaf_, wholeLeaves_}; }
    [[nodiscard]] std::span<const Node> nodes() const { return {wholeNode_, wholeNodes_}; }
    [[nodiscard]] const Box3& box() const { return box_; }
    [[nodiscard]] std::size_t bytes() const {
        return (wholeNodes_ + nodes_.size()) * sizeof(Node) + (wholeLeaves_ + leaves_.size()) * sizeof(Leaf);
    }

    /// Nodes below the root, at most: the stack that a depth-first walk needs is (kWidth - 1) times this, plus one.
    static constexpr int kMaxDepth = 24;
    static constexpr int kStackSize = (kWidth - 1) * kMaxDepth + 1;

private:
    friend class MaskedBvh;
    struct Arrays {
        LargeVector<Node> nodes;
        LargeVector<Leaf> leaves;
    };

    std::shared_ptr<const Arrays> whole_;  // of the mesh, shared by every tree from which triangles were taken
    const Node* wholeNode_ = nullptr;      // its nodes: one step less to each on a walk
    const Leaf* wholeLeaf_ = nullptr;
    std::uint32_t wholeNodes_ = 0;
    std::uint32_t wholeLeaves_ = 0;
    std::vector<Node> nodes_;  // instead of some of those: they have the numbers from wholeNodes_ on
    std::vector<Leaf> leaves_;
    Link root_;
    Box3 box_;
};

}  // namespace tactooth
