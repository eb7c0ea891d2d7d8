// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/proxy_scene.h"
#include "collision/proxy/work_budget.h"

namespace tactooth {

/// Finds and remembers the planes that separate pairs of triangles.
///
/// A plane belongs to the pose at which GJK found it. At a later pose it is only a guess until it is found anew.
class PlaneFinder {
public:
    /// A pair with its remembered plane. If there is none, `guess` is the direction from which GJK starts; zero: none.
    [[nodiscard]] WatchedPair watch(const ProxyScene& scene, const NearPair& pair, const Vec3& guess) const;
    /// Makes sure that a pair has a plane of the present pose. False if nothing separates the pair.
    [[nodiscard]] bool ensurePlane(const ProxyScene& scene, WatchedPair& watched, WorkBudget& budget) {
        return watched.plane.stamp == scene.poseStamp || refresh(scene, watched, budget);
    }
    /// Finds the plane that separates a pair best at the present pose. False if nothing separates it.
    [[nodiscard]] bool refresh(const ProxyScene& scene, WatchedPair& watched, WorkBudget& budget);
    /// Replaces the plane of a pair by the one with this normal that touches the tooth's triangle.
    void replace(const ProxyScene& scene, const Triangle3& tooth, const Vec3& normal, WatchedPair& watched);

    /// The plane last stored for a pair of a surface part, or null.
    [[nodiscard]] const SeparatingPlane* find(std::uint64_t partId, const NearPair& pair) const {
        return cache_.find(partId, pair);
    }
    /// Stores a plane that separates a pair during a whole step; it belongs to no pose. Returns the stored plane.
    const SeparatingPlane* storeOfStep(std::uint64_t partId, const NearPair& pair, const Vec3& normal, double offset) {
        TACTOOTH_ASSERT(isUnit(normal));
        return cache_.store(partId, pair, {normal, offset, kOfNoPose});
    }
    /// Forgets all planes.
    void clear() { cache_.clear(); }

private:
    static constexpr std::uint64_t kOfNoPose = 1;  // stamp; poses are numbered from 2

    SeparatingPlanes cache_;
};

/// Width of the slab between a pair along its plane, with the tool at the given pose, mm; negative: they overlap.
[[nodiscard]] inline double gapAt(const ToolShape& tool, const WatchedPair& watched, const Mat3& rotation,
                                  const Vec3& position) {
    TACTOOTH_ASSERT(isUnit(watched.plane.normal));
    const Vec3& normal = watched.plane.normal;
    const Vec3 inTool = rotation.transpose() * normal;
    return lowestAlong(tool.corners(watched.pair.tool), inTool) + normal.dot(position) - watched.plane.offset;
}

}  // namespace tactooth
