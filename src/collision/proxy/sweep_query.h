// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>
#include <utility>

#include "collision/neighbours/neighbour_list.h"
#include "collision/proxy/candidate_step.h"
#include "collision/proxy/proxy_scene.h"

namespace tactooth {

/// The most normals that a sweep query tries: those of the active constraints, and a few that it meets itself.
inline constexpr int kMaxQueryNormals = kMaxHeld + 2;

/// A triangle of the tool at the start and the end of a step, and how far it reaches along the normals of a query. In
/// the tooth's frame, mm.
struct SweptTool {
    static constexpr std::uint32_t kNone = ~0U;

    std::uint32_t triangle = kNone;
    int measured = 0;                                       ///< the first so many normals are measured
    std::array<Vec3, 6> corners;                            ///< three at the start, three at the end
    std::array<double, kMaxQueryNormals> startLow, endLow;  ///< least dot product of a corner with each normal

    /// The least dot product of a corner with a unit normal, at the start of the step.
    [[nodiscard]] double lowAtStart(const Vec3& normal) const {
        return lowestAlong(std::span<const Vec3>(corners).first(3), normal);
    }
    /// The same at the end of the step.
    [[nodiscard]] double lowAtEnd(const Vec3& normal) const {
        return lowestAlong(std::span<const Vec3>(corners).last(3), normal);
    }
};

/// The data of one search for the pairs of triangles that a step would bring together: unit normals of planes that may
/// separate many pairs, and how far triangles reach along them.
///
/// Positions, normals and lengths are in the tooth's frame, in mm and double precision. A query is for one step: all
/// calls take the same scene (with the pose at the start of the step), step and neighbour list. It is conservative:
/// `true` proves that a plane separates the two during the whole step, with more than 0 mm between them at its start
/// and at least half of the scene's margin at its end. `false` proves nothing. No call fails or allocates; a cluster or
/// triangle out of range, or a normal that is not of unit length, fires an assert.
///
/// Around a contact, dozens of pairs share the corner that touches. Along the normal of the contact they are one margin
/// apart, far less than single precision resolves. So the query measures in double precision along the normals of the
/// active constraints.
///
/// Where two faces lie on each other (the end of a bur on the floor that it has milled), the plane of the contact may
/// be tilted slightly, and the plane of the face separates thousands of pairs instead. So a plane that separates two
/// successive pairs narrowly is tried for all later pairs.
class SweepQuery {
public:
    /// A query that tries the normals of the active constraints.
    template <class Constraints>
    explicit SweepQuery(const Constraints& constraints)
        : activeCount_(constraints.activeCount()), count_(constraints.activeCount()) {
        for (int i = 0; i < count_; ++i) normals_[i] = constraints.activeNormal(i);
    }

    /// All normals to try: those of the active constraints, then those that addNarrow has added.
    [[nodiscard]] std::span<const Vec3> normals() const { return {normals_.data(), static_cast<std::size_t>(count_)}; }
    [[nodiscard]] std::span<const Vec3> activeNormals() const { return normals().first(activeSize()); }

    /// Reports the unit normal of a plane that has separated a pair by a narrow gap. The second one in succession with
    /// the same normal adds it, as long as there is room.
    void addNarrow(const Vec3& normal) {
        TACTOOTH_ASSERT(isUnit(normal));
        if (count_ < kMaxQueryNormals && normal.dot(lastNarrow_) > kSamePlane) normals_[count_++] = normal;
        lastNarrow_ = normal;
    }

    /// Measures a triangle of the tool along all normals known so far. The reference is valid until the next call.
    [[nodiscard]] const SweptTool& sweep(const ProxyScene& scene, const CandidateStep& step, std::uint32_t triangle);
    /// Measures the leaf of the tooth of a cluster along all normals known so far, for separatesCluster with the same
    /// leaf.
    void measureLeaf(const ProxyScene& scene, const NeighbourList& list, std::size_t cluster);
    /// Whether a plane with one of the normals separates all pairs of a cluster. False if its leaf was not measured.
    [[nodiscard]] bool separatesCluster(const ProxyScene& scene, const CandidateStep& step, const NeighbourList& list,
                                        std::size_t cluster);
    /// Whether a swept triangle stays in front of the plane with normal number `i` at offset `toothTop` (mm) during the
    /// whole step, `margin` (mm) being that of the scene. The triangle must be measured along that normal.
    [[nodiscard]] static bool separates(double toothTop, const SweptTool& swept, int i, double margin) {
        return swept.startLow[i] > toothTop && swept.endLow[i] - toothTop >= margin / 2;
    }

private:
    static constexpr std::size_t kPlaces = 32;  // direct-mapped: a collision costs only time
    struct Leaf {
        std::uint32_t number = SweptTool::kNone;
        int measured = 0;
        std::array<double, kMaxQueryNormals> top;  // greatest dot product of its triangles with each normal, mm
    };

    [[nodiscard]] std::size_t activeSize() const { return static_cast<std::size_t>(activeCount_); }

    std::array<Vec3, kMaxQueryNormals> normals_;
    int activeCount_ = 0;
    int count_ = 0;
    Vec3 lastNarrow_ = Vec3::Zero();
    std::array<SweptTool, kPlaces> tools_;
    std::array<Leaf, kPlaces> leaves_;
};

inline const SweptTool& SweepQuery::sweep(const ProxyScene& scene, const CandidateStep& step, std::uint32_t triangle) {
    SweptTool& swept = tools_[triangle % kPlaces];
    if (swept.triangle != triangle) {
        swept.triangle = triangle;
        swept.measured = 0;
        const Triangle3 tool = scene.tool->corners(triangle);
        const Vec3 position = scene.pose.position + step.shift;
        for (int corner = 0; corner < 3; ++corner) {
            swept.corners[corner] = step.startMatrix * tool[corner] + scene.pose.position;
            swept.corners[corner + 3] = step.matrix * tool[corner] + position;
        }
    }
    for (int& i = swept.measured; i < count_; ++i) {
        swept.startLow[i] = swept.lowAtStart(normals_[i]);
        swept.endLow[i] = swept.lowAtEnd(normals_[i]);
    }
    return swept;
}

inline void SweepQuery::measureLeaf(const ProxyScene& scene, const NeighbourList& list, std::size_t cluster) {
    const std::uint32_t number = list.leafOf(cluster);
    Leaf& measured = leaves_[number % kPlaces];
    if (measured.number != number) measured = {number, 0, {}};
    const int first = std::exchange(measured.measured, count_);
    if (first == count_) return;
    const auto top = std::span(measured.top).first(static_cast<std::size_t>(count_));
    std::ranges::fill(top.subspan(static_cast<std::size_t>(first)), -std::numeric_limits<double>::infinity());
    const NearLeaf& leaf = list.leaf(number);
    const TriangleMesh& mesh = partOf(*scene.surface, leaf.part).mesh();
    for (std::uint32_t rest = leaf.present; rest != 0; rest &= rest - 1) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 point = mesh.corner(leaf.triangle[std::countr_zero(rest)], corner);
            for (int i = first; i < count_; ++i) top[i] = std::max(top[i], normals_[i].dot(point));
        }
    }
}

inline bool SweepQuery::separatesCluster(const ProxyScene& scene, const CandidateStep& step, const NeighbourList& list,
                                         std::size_t cluster) {
    const std::uint32_t number = list.leafOf(cluster);
    const Leaf& measured = leaves_[number % kPlaces];
    if (measured.number != number) return false;
    const SweptTool& swept = sweep(scene, step, list.toolOf(cluster));
    for (int i = 0; i < measured.measured; ++i) {
        if (separates(measured.top[i], swept, i, scene.margin)) return true;
    }
    return false;
}

}  // namespace tactooth
