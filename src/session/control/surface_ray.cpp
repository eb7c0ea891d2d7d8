// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/surface_ray.h"

#include <algorithm>
#include <array>
#include <limits>

#include "collision/narrow/triangle3.h"

// Ray and triangle: T. Moeller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1), 1997. Differs
// in that both sides of a triangle count.

namespace tactooth {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Where a ray meets a triangle.
struct Meeting {
    double distance = kNever;  // along the ray, mm
    bool leaves = false;       // from behind: the ray leaves the solid
    const SurfacePart* part = nullptr;
    std::uint32_t triangle = 0;
};

Meeting meeting(const Ray& ray, const Triangle3& triangle) {
    const Vec3 ab = triangle[1] - triangle[0];
    const Vec3 ac = triangle[2] - triangle[0];
    const Vec3 p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0) return {};  // edge-on, or without area
    const Vec3 s = ray.origin - triangle[0];
    const double u = s.dot(p) / determinant;
    const Vec3 q = s.cross(ab);
    const double v = ray.direction.dot(q) / determinant;
    const double t = ac.dot(q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && t >= 0)) return {};
    return {t, determinant < 0, nullptr, 0};
}

/// A ray as the boxes of a tree are tested with it: the children of a node at once.
class BoxRay {
public:
    explicit BoxRay(const Ray& ray) : origin_(ray.origin) {
        for (int axis = 0; axis < 3; ++axis) inverse_[axis] = std::clamp(1 / ray.direction[axis], -kSteep, kSteep);
    }
    /// Distances to the entries into the children of a node; kNever where the ray misses the box or enters it after
    /// `best`.
    [[nodiscard]] std::array<double, AabbTree::kWidth> entries(const AabbTree::Node& node, double best) const {
        std::array<double, AabbTree::kWidth> enter{}, leave;
        leave.fill(best);
        for (int axis = 0; axis < 3; ++axis) {
            for (int i = 0; i < AabbTree::kWidth; ++i) {
                const double first = (node.low[axis][i] - origin_[axis] - kMargin) * inverse_[axis];
                const double second = (node.high[axis][i] - origin_[axis] + kMargin) * inverse_[axis];
                enter[i] = std::max(enter[i], std::min(first, second));
                leave[i] = std::min(leave[i], std::max(first, second));
            }
        }
        for (int i = 0; i < AabbTree::kWidth; ++i) {
            const bool isMet = node.low[0][i] <= node.high[0][i] && enter[i] <= leave[i];
            if (!isMet) enter[i] = kNever;
        }
        return enter;
    }

private:
    /// mm. Around a box: one as thin as the triangle in it must not be missed, nor one in whose side the ray lies.
    static constexpr double kMargin = 1e-9;
    /// Stands for infinity along an axis that the ray is across of: 0 times it is a number.
    static constexpr double kSteep = 1e300;

    Vec3 origin_;
    Vec3 inverse_;
};

/// Nodes and leaves that a ray enters, the nearest on top.
class NearestFirst {
public:
    struct Entry {
        AabbTree::Link link;
        double distance;  // to the entry, mm
    };

    explicit NearestFirst(AabbTree::Link root) { entries_[size_++] = {root, 0}; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] Entry pop() { return entries_[--size_]; }
    void push(const AabbTree::Node& node, const std::array<double, AabbTree::kWidth>& distances) {
        const int first = size_;
        for (int i = 0; i < AabbTree::kWidth; ++i) {
            if (distances[i] == kNever) continue;
            int at = size_++;
            for (; at > first && entries_[at - 1].distance < distances[i]; --at) entries_[at] = entries_[at - 1];
            entries_[at] = {node.child[i], distances[i]};
        }
    }

private:
    std::array<Entry, AabbTree::kStackSize> entries_;
    int size_ = 0;
};

/// Which sides of the triangles count.
enum class Sides { Both, Outside };

/// Which meeting is wanted.
enum class Wanted { First, Any };

template <Wanted kWanted = Wanted::First>
Meeting firstOf(const SurfacePart& part, const VisibleBase& visible, const Ray& ray, Sides sides, Meeting best) {
    const auto& [tree, hidden] = visible;
    if (tree.empty()) return best;
    const BoxRay boxRay(ray);
    NearestFirst waiting(tree.rootLink());
    while (!waiting.empty()) {
        const auto [link, distance] = waiting.pop();
        if (distance > best.distance) continue;
        if (!link.isLeaf()) {
            const AabbTree::Node& node = tree.node(link);
            waiting.push(node, boxRay.entries(node, best.distance));
            continue;
        }
        const AabbTree::Leaf& leaf = tree.leaf(link);
        for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
            const std::uint32_t triangle = leaf.triangle[lane];
            if (hidden != nullptr && isHidden(*hidden, triangle)) continue;
            const Meeting found = meeting(ray, cornersOf(part.mesh(), triangle));
            if (found.leaves && sides == Sides::Outside) continue;
            if (!(found.distance < best.distance)) continue;
            best = {found.distance, found.leaves, &part, triangle};
            if (kWanted == Wanted::Any) return best;
        }
    }
    return best;
}

Meeting firstOf(const Surface& surface, const Ray& ray, Sides sides) {
    Meeting best = firstOf(*surface.base, visibleBase(surface), ray, sides, {});
    for (const auto& patch : surface.patches) best = firstOf(*patch, {patch->tree(), nullptr}, ray, sides, best);
    return best;
}

std::optional<SurfaceHit> hitOf(const Meeting& best) {
    if (best.part == nullptr) return std::nullopt;
    return SurfaceHit{best.distance, best.part->mesh().areaVector(best.triangle).normalized(),
                      best.part->isAdjacent(best.triangle)};
}

}  // namespace

std::optional<double> firstHit(const Surface& surface, const Ray& ray) {
    const Meeting best = firstOf(surface, ray, Sides::Both);
    return best.distance < kNever ? std::optional(best.distance) : std::nullopt;
}

bool meetsAny(const Surface& surface, const Ray& ray) {
    const auto meets = [&](const SurfacePart& part, const VisibleBase& visible) {
        return firstOf<Wanted::Any>(part, visible, ray, Sides::Both, {}).part != nullptr;
    };
    return meets(*surface.base, visibleBase(surface)) || std::ranges::any_of(surface.patches, [&](const auto& patch) {
               return meets(*patch, {patch->tree(), nullptr});
           });
}

std::optional<SurfaceHit> firstHitWithNormal(const Surface& surface, const Ray& ray) {
    return hitOf(firstOf(surface, ray, Sides::Both));
}

std::optional<SurfaceHit> firstSeen(const Surface& surface, const Ray& ray) {
    return hitOf(firstOf(surface, ray, surface.closed ? Sides::Outside : Sides::Both));
}

double depthInside(const SurfacePart& whole, const Vec3& place, const Vec3& up) {
    const Meeting first = firstOf(whole, {whole.tree(), nullptr}, {place, up}, Sides::Both, {});
    return first.leaves ? first.distance : 0;
}

}  // namespace tactooth
