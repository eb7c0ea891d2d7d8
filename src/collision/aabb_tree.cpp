// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/aabb_tree.h"

#include <array>
#include <cassert>
#include <limits>
#include <memory>

#include "geometry/parallel_for.h"

// Binned surface-area heuristic: I. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE
// Symposium on Interactive Ray Tracing 2007, section 3. Differs from the paper: a node has eight children, found by
// splitting the child of the largest area again and again, and a leaf is one packet of eight triangles, so the split
// cost counts packets, not triangles.

namespace tactooth {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kBins = 16;                     // more than 16 bins gains nothing measurable on scanned teeth
constexpr std::size_t kParallelRange = 8192;  // below this a task costs more than it saves
constexpr int kBalancedDepth = 8;             // deeper nodes split at the median: bounds the depth for any input

struct Bounds {
    Vec3f low = Vec3f::Constant(kInfinity);
    Vec3f high = Vec3f::Constant(-kInfinity);

    void extend(const Vec3f& point) { low = low.cwiseMin(point), high = high.cwiseMax(point); }
    void extend(const Bounds& other) { low = low.cwiseMin(other.low), high = high.cwiseMax(other.high); }
    [[nodiscard]] float halfArea() const {
        if (!(low.x() <= high.x())) return 0.0F;
        const Vec3f size = high - low;
        return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
    }
};

struct Item {
    Bounds bounds;
    std::uint32_t triangle;

    /// Twice the centre of the box.
    [[nodiscard]] Vec3f centre() const { return bounds.low + bounds.high; }
};

using Range = std::span<Item>;

struct Child {
    Range range;
    Bounds bounds;
};

struct BuildNode {
    int count = 0;
    std::array<Child, AabbTree::kWidth> children;
    std::array<std::unique_ptr<BuildNode>, AabbTree::kWidth> inner;  // null: the child is a leaf
};

Bounds boundsOf(Range range) {
    Bounds bounds;
    for (const Item& item : range) bounds.extend(item.bounds);
    return bounds;
}

std::size_t packets(std::size_t count) { return (count + AabbTree::kWidth - 1) / AabbTree::kWidth; }

/// Cuts at the middle item along the longest axis of the centres. Equal keys fall in the order of the triangle
/// numbers, so the result does not depend on the library's selection algorithm.
std::size_t splitAtMedian(Range range, int axis) {
    const std::size_t half = packets(range.size()) / 2 * AabbTree::kWidth;
    std::sort(range.begin(), range.end(), [axis](const Item& a, const Item& b) {
        const float left = a.centre()[axis];
        const float right = b.centre()[axis];
        return left != right ? left < right : a.triangle < b.triangle;
    });
    return half;
}

struct Bins {
    std::array<Bounds, kBins> bounds;
    std::array<std::size_t, kBins> count{};
};

/// The bin border of the lowest cost, 1..kBins-1, or 0 when every item falls into one bin.
int cheapestBorder(const Bins& bins) {
    std::array<float, kBins> rightCost{};
    Bounds right;
    std::size_t rightCount = 0;
    for (int bin = kBins - 1; bin > 0; --bin) {
        right.extend(bins.bounds[bin]);
        rightCount += bins.count[bin];
        rightCost[bin] = right.halfArea() * static_cast<float>(packets(rightCount));
    }
    Bounds left;
    std::size_t leftCount = 0;
    int best = 0;
    float bestCost = kInfinity;
    for (int border = 1; border < kBins; ++border) {
        left.extend(bins.bounds[border - 1]);
        leftCount += bins.count[border - 1];
        const float cost = left.halfArea() * static_cast<float>(packets(leftCount)) + rightCost[border];
        if (leftCount != 0 && rightCost[border] != 0.0F && cost < bestCost) bestCost = cost, best = border;
    }
    return best;
}

/// Reorders `range` into two non-empty parts and returns the size of the first.
std::size_t split(Range range, bool balanced) {
    Bounds centres;
    for (const Item& item : range) centres.extend(item.centre());
    int axis = 0;
    const Vec3f size = centres.high - centres.low;
    size.maxCoeff(&axis);
    if (balanced || !(size[axis] > 0.0F)) return splitAtMedian(range, axis);

    const float scale = kBins / size[axis];
    const auto binOf = [&](const Item& item) {
        return std::min(kBins - 1, static_cast<int>((item.centre()[axis] - centres.low[axis]) * scale));
    };
    Bins bins;
    for (const Item& item : range) {
        const int bin = binOf(item);
        bins.bounds[bin].extend(item.bounds);
        ++bins.count[bin];
    }
    const int border = cheapestBorder(bins);
    if (border == 0) return splitAtMedian(range, axis);
    const auto middle =
        std::partition(range.begin(), range.end(), [&](const Item& item) { return binOf(item) < border; });
    return static_cast<std::size_t>(middle - range.begin());
}

/// The child worth splitting next: the largest (by area, or by count where depth is to be bounded) that is not a leaf
/// yet, or -1.
int widestChild(const BuildNode& node, bool balanced) {
    int widest = -1;
    float width = -1.0F;
    for (int i = 0; i < node.count; ++i) {
        const Child& child = node.children[i];
        if (child.range.size() <= AabbTree::kWidth) continue;
        const float candidate = balanced ? static_cast<float>(child.range.size()) : child.bounds.halfArea();
        if (candidate > width) width = candidate, widest = i;
    }
    return widest;
}

std::unique_ptr<BuildNode> build(Range range, int depth) {
    auto node = std::make_unique<BuildNode>();
    node->children[0] = {range, boundsOf(range)};
    node->count = 1;
    const bool balanced = depth > kBalancedDepth;
    while (node->count < AabbTree::kWidth) {
        const int widest = widestChild(*node, balanced);
        if (widest < 0) break;
        const Range whole = node->children[widest].range;
        const std::size_t cut = split(whole, balanced);
        const Range left = whole.first(cut);
        const Range right = whole.subspan(cut);
        node->children[widest] = {left, boundsOf(left)};
        node->children[node->count++] = {right, boundsOf(right)};
    }
    const auto descend = [&](std::size_t i) {
        const Range part = node->children[i].range;
        if (part.size() > AabbTree::kWidth) node->inner[i] = build(part, depth + 1);
    };
    const auto count = static_cast<std::size_t>(node->count);
    if (range.size() > kParallelRange) {
        parallelFor(count, descend);
    } else {
        for (std::size_t i = 0; i < count; ++i) descend(i);
    }
    return node;
}

AabbTree::Leaf makeLeaf(const TriangleMesh& mesh, Range range) {
    AabbTree::Leaf leaf{};
    leaf.count = static_cast<std::uint32_t>(range.size());
    for (std::size_t lane = 0; lane < AabbTree::kWidth; ++lane) {
        const std::uint32_t triangle = range[lane < range.size() ? lane : 0].triangle;
        leaf.triangle[lane] = triangle;
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3f& point = mesh.vertices[mesh.triangles[triangle][corner]];
            for (int axis = 0; axis < 3; ++axis) leaf.corner[corner][axis][lane] = point[axis];
        }
    }
    return leaf;
}

/// Lays the nodes out depth first: a child follows its parent closely in memory.
std::uint32_t flatten(const TriangleMesh& mesh, const BuildNode& from, std::vector<AabbTree::Node>& nodes,
                      std::vector<AabbTree::Leaf>& leaves) {
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.emplace_back();
    for (int i = 0; i < AabbTree::kWidth; ++i) {
        const Bounds bounds = i < from.count ? from.children[i].bounds : Bounds{};
        for (int axis = 0; axis < 3; ++axis) {
            nodes[index].low[axis][i] = bounds.low[axis];
            nodes[index].high[axis][i] = bounds.high[axis];
        }
        if (i >= from.count) continue;
        if (from.inner[i] != nullptr) {
            const std::uint32_t child = flatten(mesh, *from.inner[i], nodes, leaves);
            nodes[index].child[i] = AabbTree::Link::toNode(child);
        } else {
            nodes[index].child[i] = AabbTree::Link::toLeaf(static_cast<std::uint32_t>(leaves.size()));
            leaves.push_back(makeLeaf(mesh, from.children[i].range));
        }
    }
    return index;
}

}  // namespace

AabbTree::AabbTree(const TriangleMesh& mesh) {
    if (mesh.empty()) return;
    assert(mesh.triangles.size() < (std::size_t{1} << 31));
    std::vector<Item> items(mesh.triangles.size());
    const auto enclose = [&](std::size_t i) {
        for (const std::uint32_t vertex : mesh.triangles[i]) items[i].bounds.extend(mesh.vertices[vertex]);
        items[i].triangle = static_cast<std::uint32_t>(i);
    };
    parallelFor(items.size(), enclose, kParallelRange);
    const std::unique_ptr<BuildNode> tree = build(items, 0);
    nodes_.reserve(items.size() / 24 + 1);
    leaves_.reserve(items.size() / 5 + 1);
    flatten(mesh, *tree, nodes_, leaves_);
    for (const Child& child : std::span(tree->children).first(tree->count)) {
        box_.extend(Box3(child.bounds.low.cast<double>(), child.bounds.high.cast<double>()));
    }
}

}  // namespace tactooth
