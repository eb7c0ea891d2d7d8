// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/plane_finder.h"

#include <algorithm>

#include "collision/narrow/gjk.h"

namespace tactooth {
namespace {

constexpr double kTouchingMargins = 10;  // a gap below so many margins: the triangles' own planes are tried
constexpr double kRelativeGap = 0.9;     // of the gap of GJK's plane: what the other plane must leave

/// Takes the plane of one of the two triangles, if it separates them nearly as well. Where the tool slides toward a
/// concave edge of the tooth, GJK's plane stands across its path, a margin in front of the edge. The plane of the
/// triangle behind the edge lets the tool slide on.
void preferFace(const Triangle3& tooth, const Triangle3& tool, double margin, SeparatingPlane& plane) {
    const double needed = kRelativeGap * std::min(margin, lowestAlong(tool, plane.normal) - plane.offset);
    for (const Triangle3* face : {&tooth, &tool}) {
        const Vec3 area = ((*face)[1] - (*face)[0]).cross((*face)[2] - (*face)[0]);
        const double length = area.norm();
        if (!(length > 0)) continue;
        for (const Vec3& normal : {Vec3(area / length), Vec3(area / -length)}) {
            const double back = highestAlong(tooth, normal);
            if (lowestAlong(tool, normal) - back < needed) continue;
            plane.normal = normal;
            plane.offset = back;
            return;
        }
    }
}

}  // namespace

WatchedPair PlaneFinder::watch(const ProxyScene& scene, const NearPair& pair, const Vec3& guess) const {
    TACTOOTH_ASSERT(guess.allFinite());
    const SeparatingPlane* known = cache_.find(scene.part(pair).id(), pair);
    return {pair, known != nullptr ? *known : SeparatingPlane{guess, 0, kOfNoPose}};
}

bool PlaneFinder::refresh(const ProxyScene& scene, WatchedPair& watched, WorkBudget& budget) {
    const SurfacePart& part = scene.part(watched.pair);
    const Triangle3 tooth = cornersOf(part.mesh(), watched.pair.tooth);
    const Triangle3 tool = scene.toolTriangle(watched.pair);
    SeparatingPlane& plane = watched.plane;
    const GjkResult result =
        distanceBetween(tooth, tool, plane.normal.isZero() ? Vec3(tool[0] - tooth[0]) : plane.normal);
    budget.addDistance();
    if (!result.separated) return false;
    plane = {result.normal, highestAlong(tooth, result.normal), scene.poseStamp};
    if (result.distance < kTouchingMargins * scene.margin) preferFace(tooth, tool, scene.margin, plane);
    TACTOOTH_ASSERT(isUnit(plane.normal));
    cache_.store(part.id(), watched.pair, plane);
    return true;
}

void PlaneFinder::replace(const ProxyScene& scene, const Triangle3& tooth, const Vec3& normal, WatchedPair& watched) {
    TACTOOTH_ASSERT(isUnit(normal));
    watched.plane = {normal, highestAlong(tooth, normal), scene.poseStamp};
    cache_.store(scene.part(watched.pair).id(), watched.pair, watched.plane);
}

}  // namespace tactooth
