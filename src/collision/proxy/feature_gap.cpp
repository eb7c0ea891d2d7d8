// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/feature_gap.h"

#include <algorithm>

namespace tactooth {

FeatureGap gapOf(const ProxyScene& scene, const WatchedPair& watched, const FeaturePair& features,
                 const Pose& toolInTooth) {
    const Triangle3 tooth = scene.toothTriangle(watched.pair);
    const Triangle3 tool = scene.tool->cornersAt(toolInTooth, watched.pair.tool);
    const Vec3& normal = watched.plane.normal;
    TACTOOTH_ASSERT(isUnit(normal));
    TACTOOTH_ASSERT(features.tool >= 0 && features.tool < 3 && features.tooth >= 0 && features.tooth < 3);
    if (const auto gap = gapBetween(features, tooth, tool, normal)) return *gap;
    return {normal.dot(tool[features.tool]) - watched.plane.offset, normal, tool[features.tool]};
}

FeaturePair lowestCorner(const ProxyScene& scene, const CandidateStep& step, const WatchedPair& watched) {
    const Triangle3 tool = scene.tool->corners(watched.pair.tool);
    const Vec3 inTool = step.matrix.transpose() * watched.plane.normal;
    const auto lowest = std::min_element(tool.begin(), tool.end(),
                                         [&](const Vec3& p, const Vec3& q) { return p.dot(inTool) < q.dot(inTool); });
    return {FeaturePair::Kind::CornerOverPlane, 0, static_cast<int>(lowest - tool.begin())};
}

std::optional<FeaturePair> blockingFeatures(const ProxyScene& scene, const CandidateStep& step,
                                            const WatchedPair& watched) {
    const Triangle3 tooth = scene.toothTriangle(watched.pair);
    const ContactFeatures touching(tooth, scene.toolTriangle(watched.pair), watched.plane.normal);
    const Pose end = step.end(scene.pose);
    std::optional<FeaturePair> nearest;
    double least = scene.margin / 2;
    for (int i = 0; i < touching.count; ++i) {
        if (gapOf(scene, watched, touching.pairs[i], scene.pose).gap < scene.margin / 2)
            continue;  // they do not face each other
        const double gap = gapOf(scene, watched, touching.pairs[i], end).gap;
        if (gap < least) least = gap, nearest = touching.pairs[i];
    }
    return nearest;
}

bool stillTouch(const ProxyScene& scene, const WatchedPair& watched, const FeaturePair& features) {
    const Triangle3 tooth = scene.toothTriangle(watched.pair);
    const ContactFeatures touching(tooth, scene.toolTriangle(watched.pair), watched.plane.normal);
    const auto end = touching.pairs.begin() + touching.count;
    return std::find(touching.pairs.begin(), end, features) != end;
}

}  // namespace tactooth
