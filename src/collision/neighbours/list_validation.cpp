// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/neighbours/neighbour_list.h"

namespace tactooth {
namespace {

/// The direction of one of eight slabs.
Vec3f laneOf(const float (&normal)[3][8], std::size_t lane) {
    return {normal[0][lane], normal[1][lane], normal[2][lane]};
}

bool isAtMostUnit(const Vec3f& normal) { return normal.allFinite() && normal.norm() <= 1 + 1e-5F; }

}  // namespace

void NeighbourList::validate(const Surface& surface) const {
    if (!made_) return;
    TACTOOTH_ASSERT(near_.count <= limit_ && near_.count <= near_.capacity());
    TACTOOTH_ASSERT(near_.leafCount <= near_.leaves.size());
    TACTOOTH_ASSERT(near_.nodeCount <= near_.nodes.size());
    TACTOOTH_ASSERT(openedCount_ <= pairs_.size());
    TACTOOTH_ASSERT(opened_.size() == near_.capacity());
    TACTOOTH_ASSERT(contactMargin_.along.allFinite() && contactMargin_.around >= 0 && contactMargin_.turn >= 0);
    for (std::size_t i = 0; i < near_.leafCount; ++i) {
        const NearLeaf& leaf = near_.leaves[i];
        TACTOOTH_ASSERT(leaf.present != 0 && leaf.present <= 0xFF);
        const std::size_t triangles = partOf(surface, leaf.part).mesh().triangles.size();
        for (std::size_t lane = 0; lane < 8; ++lane) {
            TACTOOTH_ASSERT(leaf.triangle[lane] < triangles);
            TACTOOTH_ASSERT(isAtMostUnit(laneOf(leaf.normal, lane)));
        }
    }
    std::size_t opened = 0;
    for (std::size_t cluster = 0; cluster < near_.count; ++cluster) {
        const ClusterPacket& packet = near_.packets[cluster / 8];
        const std::size_t lane = cluster % 8;
        TACTOOTH_ASSERT(packet.leaf[lane] < near_.leafCount);
        TACTOOTH_ASSERT(packet.tool[lane] < tool_->mesh().triangles.size());
        validateSlab(packet, lane);
        if (opened_[cluster] == kClosed) continue;
        TACTOOTH_ASSERT(opened_[cluster] < openedCount_);
        ++opened;
    }
    TACTOOTH_ASSERT(opened == openedCount_);
    const bool isAroundKnown = around_.deviation >= 0;  // else its packets are those of an older list
    for (std::size_t i = 0; isAroundKnown && i < around_.count; ++i) {
        TACTOOTH_ASSERT(around_.packets[i] % 8 == 0 && around_.packets[i] < near_.count);
        TACTOOTH_ASSERT(i == 0 || around_.packets[i - 1] < around_.packets[i]);
    }
}

/// Asserts that a cluster's slab is as wide as stated: along its normal, the tool's triangle begins at least the gap
/// beyond the end of the tooth's leaf.
void NeighbourList::validateSlab(const ClusterPacket& packet, std::size_t lane) const {
    const Vec3f normal = laneOf(packet.normal, lane);
    TACTOOTH_ASSERT(isAtMostUnit(normal));
    TACTOOTH_ASSERT(std::isfinite(packet.gap[lane]));
    const NearLeaf& leaf = near_.leaves[packet.leaf[lane]];
    float high = -std::numeric_limits<float>::infinity(), low = std::numeric_limits<float>::infinity();
    for (const auto& corner : leaf.corner) {
        for (std::size_t i = 0; i < 8; ++i) high = std::max(high, normal.dot(laneOf(corner, i)));
    }
    for (const Vec3f& corner : tool_->floatCorners(packet.tool[lane])) {
        low = std::min(low, normal.dot(corner));
        const Vec3f centre(packet.centre[0][lane], packet.centre[1][lane], packet.centre[2][lane]);
        TACTOOTH_ASSERT((corner - centre).norm() <= packet.radius[lane] * (1 + 1e-5F));
    }
    TACTOOTH_ASSERT(low - high >= packet.gap[lane] - 2 * static_cast<float>(near_.slack));
}

}  // namespace tactooth
