// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/self_intersection.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/triangle_intersection.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

// Self-intersection of a mesh by its own bounding-volume hierarchy: C. Ericson, "Real-Time Collision Detection", 2005,
// section 6.3. Differs from the book: each leaf searches the whole tree for leaves of the same or a higher index, so
// leaves are independent tasks, and eight boxes are tested at a time.

namespace tactooth {
namespace {

struct LeafBoxes {
    Vec3x8 low, high;
};

LeafBoxes boxesOf(const AabbTree::Leaf& leaf) {
    const Vec3x8 a = Vec3x8::load(leaf.corner[0]), b = Vec3x8::load(leaf.corner[1]), c = Vec3x8::load(leaf.corner[2]);
    return {min(min(a, b), c), max(max(a, b), c)};
}

/// One box in single precision, wide enough for triangles that only come near.
struct NearBox {
    std::array<float, 3> low, high;

    void extend(const Vec3f& point) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    }
    void grow() {
        for (int axis = 0; axis < 3; ++axis) {
            const float reach = 2 * static_cast<float>(kIntersectionDistance) +
                                1e-6F * std::max(std::abs(low[axis]), std::abs(high[axis]));
            low[axis] -= reach;
            high[axis] += reach;
        }
    }
    /// One bit for each of eight boxes that overlaps this one.
    [[nodiscard]] std::uint32_t meets(const LeafBoxes& other) const {
        const Vec3x8 here = Vec3x8::all(low[0], low[1], low[2]), there = Vec3x8::all(high[0], high[1], high[2]);
        return lessEqual(other.low.x, there.x) & lessEqual(other.low.y, there.y) & lessEqual(other.low.z, there.z) &
               lessEqual(here.x, other.high.x) & lessEqual(here.y, other.high.y) & lessEqual(here.z, other.high.z);
    }
};

NearBox emptyBox() {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    return {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
}

NearBox boxOf(const AabbTree::Leaf& leaf, std::uint32_t lane) {
    NearBox box = emptyBox();
    for (const auto& corner : leaf.corner) box.extend(Vec3f(corner[0][lane], corner[1][lane], corner[2][lane]));
    box.grow();
    return box;
}

/// Finds the triangles that cross those of one leaf, in that leaf and in leaves of higher index.
class LeafSearch {
public:
    LeafSearch(const SurfacePart& part, std::uint32_t leaf)
        : mesh_(part.mesh()), tree_(part.tree()), number_(leaf), leaf_(tree_.leaves()[leaf]) {
        TACTOOTH_ASSERT(leaf_.count >= 1 && leaf_.count <= AabbTree::kWidth);
        NearBox all = emptyBox();
        for (std::uint32_t lane = 0; lane < leaf_.count; ++lane) {
            boxes_[lane] = boxOf(leaf_, lane);
            for (const auto& corner : leaf_.corner)
                all.extend(Vec3f(corner[0][lane], corner[1][lane], corner[2][lane]));
        }
        all.grow();
        all_ = all;
    }

    /// Appends the triangles that cross. False if all leaves together needed more than `most` tests.
    bool run(std::vector<std::uint32_t>& crossing, std::atomic<std::uint64_t>& tests, std::uint64_t most) {
        std::array<AabbTree::Link, AabbTree::kStackSize> stack;
        int size = 0;
        stack[size++] = tree_.rootLink();
        while (size > 0) {
            const AabbTree::Link link = stack[--size];
            if (link.isLeaf()) {
                if (link.index() >= number_) meet(link, crossing);
                if (tests_ > 4096 && tests.fetch_add(std::exchange(tests_, 0)) > most) return false;
                continue;
            }
            const AabbTree::Node& node = tree_.node(link);
            std::uint32_t hits = all_.meets({Vec3x8::load(node.low), Vec3x8::load(node.high)});
            TACTOOTH_ASSERT(size + std::popcount(hits) <= AabbTree::kStackSize);
            for (; hits != 0; hits &= hits - 1) stack[size++] = node.child[std::countr_zero(hits)];
        }
        return tests.fetch_add(tests_) <= most;
    }

private:
    void meet(AabbTree::Link link, std::vector<std::uint32_t>& crossing) {
        const AabbTree::Leaf& other = tree_.leaf(link);
        const LeafBoxes boxes = boxesOf(other);
        const bool isSame = link.index() == number_;
        ++tests_;
        for (std::uint32_t lane = 0; lane < leaf_.count; ++lane) {
            if (isDegenerate(mesh_.triangles[leaf_.triangle[lane]])) continue;
            std::uint32_t near = boxes_[lane].meets(boxes) & ((1U << other.count) - 1U);
            if (isSame) near &= ~((2U << lane) - 1U);  // each pair once
            for (; near != 0; near &= near - 1) {
                const std::uint32_t a = leaf_.triangle[lane], b = other.triangle[std::countr_zero(near)];
                ++tests_;
                if (isDegenerate(mesh_.triangles[b]) || !trianglesIntersect(mesh_, a, b)) continue;
                crossing.push_back(a);
                crossing.push_back(b);
            }
        }
    }

    const TriangleMesh& mesh_;
    const AabbTree& tree_;
    std::uint32_t number_;
    const AabbTree::Leaf& leaf_;
    std::array<NearBox, AabbTree::kWidth> boxes_;
    NearBox all_;
    std::uint64_t tests_ = 0;
};

std::uint64_t enoughTests(std::size_t triangles) {
    // A triangle of a sound surface shares corners with twelve others, and some more overlap its box. In a fan, each
    // triangle touches all others.
    constexpr std::uint64_t kATriangle = 100, kAtLeast = 20'000'000;
    return std::max<std::uint64_t>(kAtLeast, kATriangle * triangles);
}

}  // namespace

std::optional<std::vector<std::uint32_t>> selfIntersectingTriangles(const SurfacePart& part, std::uint64_t most) {
    const std::size_t leaves = part.tree().leaves().size();
    std::vector<std::vector<std::uint32_t>> found(leaves);
    std::atomic<std::uint64_t> tests{0};
    parallelFor(
        leaves,
        [&](std::size_t leaf) {
            if (tests.load(std::memory_order_relaxed) > most) return;
            LeafSearch(part, static_cast<std::uint32_t>(leaf)).run(found[leaf], tests, most);
        },
        64);
    if (tests.load() > most) return std::nullopt;
    std::vector<std::uint32_t> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    TACTOOTH_ASSERT(all.empty() || all.back() < part.mesh().triangles.size());
    TACTOOTH_ASSERT(all.size() != 1);  // it takes two to cross
    return all;
}

std::optional<std::vector<std::uint32_t>> selfIntersectingTriangles(const SurfacePart& part) {
    return selfIntersectingTriangles(part, enoughTests(part.mesh().triangles.size()));
}

}  // namespace tactooth
