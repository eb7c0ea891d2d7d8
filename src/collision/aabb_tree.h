// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "collision/simd8.h"
#include "geometry/large_pages.h"
#include "geometry/triangle_mesh.h"

namespace tactooth {

/// Bounding-volume hierarchy over the triangles of a mesh: nodes of eight children, leaves of up to eight triangles,
/// each stored side by side in the order in which a query walks over them. Boxes are single precision and hold their
/// triangles exactly (a mesh keeps single precision too). Built once, read by any number of threads.
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
    /// touches.
    struct alignas(32) Node {
        float low[3][kWidth];
        float high[3][kWidth];
        Link child[kWidth];
    };

    /// Up to eight triangles, corner by corner and axis by axis. Unused lanes repeat the first triangle.
    struct alignas(32) Leaf {
        float corner[3][3][kWidth];
        std::uint32_t triangle[kWidth];
        std::uint32_t count;
    };

    AabbTree() = default;
    explicit AabbTree(const TriangleMesh& mesh);

    [[nodiscard]] bool empty() const { return nodes_.empty(); }
    [[nodiscard]] const Node& root() const { return nodes_.front(); }
    [[nodiscard]] const Node& node(Link link) const { return nodes_[link.index()]; }
    [[nodiscard]] const Leaf& leaf(Link link) const { return leaves_[link.index()]; }
    [[nodiscard]] std::span<const Leaf> leaves() const { return leaves_; }
    [[nodiscard]] const Box3& box() const { return box_; }
    [[nodiscard]] std::size_t bytes() const { return nodes_.size() * sizeof(Node) + leaves_.size() * sizeof(Leaf); }

    /// Nodes below the root, at most: the stack that a depth-first walk needs is (kWidth - 1) times this, plus one.
    static constexpr int kMaxDepth = 24;
    static constexpr int kStackSize = (kWidth - 1) * kMaxDepth + 1;

private:
    LargeVector<Node> nodes_;
    LargeVector<Leaf> leaves_;
    Box3 box_;
};

}  // namespace tactooth
