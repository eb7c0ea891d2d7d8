// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "collision/proxy/candidate_step.h"
#include "collision/proxy/proxy_scene.h"

namespace tactooth {

// The features (corners, edges, faces) by which a pair of triangles touches when the tool may rotate.

/// How far two features are apart with the tool at `toolInTooth`. If the features have no normal of their own, this is
/// the distance of the tool's corner from the pair's plane.
[[nodiscard]] FeatureGap gapOf(const ProxyScene& scene, const WatchedPair& watched, const FeaturePair& features,
                               const Pose& toolInTooth);

/// The corner of the tool's triangle that the step brings nearest to the plane of the pair.
[[nodiscard]] FeaturePair lowestCorner(const ProxyScene& scene, const CandidateStep& step, const WatchedPair& watched);

/// Of the features of a pair that could meet, those that the step brings nearest. None if it brings none nearer than
/// half the margin.
[[nodiscard]] std::optional<FeaturePair> blockingFeatures(const ProxyScene& scene, const CandidateStep& step,
                                                          const WatchedPair& watched);

/// Whether features that held the tool may still hold it at the present pose. The tool may have slid off them.
[[nodiscard]] bool stillTouch(const ProxyScene& scene, const WatchedPair& watched, const FeaturePair& features);

}  // namespace tactooth
