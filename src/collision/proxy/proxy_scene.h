// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <numbers>

#include "collision/narrow/contact_features.h"
#include "collision/neighbours/separating_planes.h"
#include "collision/neighbours/tool_shape.h"
#include "collision/proxy/move_result.h"
#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// The tool, the surface of the tooth, and the pose of the tool. All parts of the proxy solver read them.
struct ProxyScene {
    std::shared_ptr<const ToolShape> tool;  ///< never null
    Freedom freedom = Freedom::Translation;
    std::shared_ptr<const Surface> surface;  ///< null until the first setSurface
    Pose pose;                               ///< of the tool in the tooth's frame
    std::uint64_t poseStamp = 2;             ///< number of the pose; a plane stores the number of its pose
    double margin = 0;                       ///< the distance that the proxy keeps from the tooth, mm

    [[nodiscard]] const SurfacePart& part(const NearPair& pair) const { return partOf(*surface, pair.part); }
    /// The tooth's triangle of a pair, mm.
    [[nodiscard]] Triangle3 toothTriangle(const NearPair& pair) const {
        TACTOOTH_ASSERT(pair.tooth < part(pair).mesh().triangles.size());
        return cornersOf(part(pair).mesh(), pair.tooth);
    }
    /// The tool's triangle of a pair with the tool at the present pose, in the tooth's frame, mm.
    [[nodiscard]] Triangle3 toolTriangle(const NearPair& pair) const { return tool->cornersAt(pose, pair.tool); }
    /// The characteristic length, mm: makes a rotation (rad) comparable with a translation (mm). It is the radius of
    /// gyration of a rod as long as the tool.
    [[nodiscard]] double characteristicLength() const { return tool->radius() / std::numbers::sqrt3; }
    [[nodiscard]] bool rotates() const { return freedom == Freedom::TranslationAndRotation; }
};

/// The pairs that were active at the end of the last iteration. The next iteration starts with their planes.
struct ActiveContacts {
    std::array<WatchedPair, kMaxHeld> pairs{};
    std::array<FeaturePair, kMaxHeld> features{};  ///< of each pair; only with 6 degrees of freedom
    int count = 0;

    [[nodiscard]] std::span<const WatchedPair> all() const {
        TACTOOTH_ASSERT(count >= 0 && count <= kMaxHeld);
        return std::span(pairs).first(static_cast<std::size_t>(count));
    }
};

}  // namespace tactooth
