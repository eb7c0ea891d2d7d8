// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "collision/bvh/surface.h"
#include "collision/neighbours/tool_shape.h"
#include "collision/neighbours/transformed_leaf.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// Up to eight triangles of a tooth, a leaf of its tree, in the tool's frame.
struct alignas(32) NearLeaf {
    float corner[3][3][AabbTree::kWidth];  ///< corner by corner, axis by axis, mm
    float normal[3][AabbTree::kWidth];     ///< unit; shorter where a triangle has no area
    std::uint32_t triangle[AabbTree::kWidth];
    std::uint32_t part;
    std::uint32_t present;  ///< one bit for each triangle that is there
};

/// Eight clusters side by side. A cluster is a leaf of the tooth against one triangle of the tool, and a slab between
/// them: along `normal` (of the tool's frame, of length 1 at most, from tooth to tool) they are `gap` mm apart, or
/// overlap by that where it is negative.
struct alignas(32) ClusterPacket {
    float normal[3][8];
    float gap[8];
    float centre[3][8];  ///< ball around the tool's triangle, mm
    float radius[8];
    std::uint32_t leaf[8];  ///< place in `leaves`
    std::uint32_t tool[8];  ///< triangle of the tool
};

/// Children of a node of the tooth's tree that may be near and have not been looked into yet, each with a slab between
/// it and the whole tool, in the tool's frame as those of clusters.
struct alignas(32) NearNode {
    float normal[3][8];
    float gap[8];
    float loss[8];  ///< what a turn makes the gap less by at most, per chord, mm
    AabbTree::Link child[8];
    SupportPlanes::Number side[8];  ///< of the tool, that looks to the child
    std::uint32_t part;
    std::uint32_t closed;  ///< one bit for each child that may be near and was not looked into
    std::uint32_t exact;   ///< one bit for each leaf whose gap is that of its triangles, not of its disc
};

/// All that is near a tool. Fixed memory: filling it allocates nothing.
struct NearClusters {
    explicit NearClusters(std::size_t capacity) : nodes(capacity / 8), leaves(capacity / 4), packets(capacity / 8) {}

    [[nodiscard]] std::size_t capacity() const { return packets.size() * 8; }

    std::vector<NearNode> nodes;
    std::vector<NearLeaf> leaves;
    std::vector<ClusterPacket> packets;
    std::size_t nodeCount = 0;
    std::size_t leafCount = 0;
    std::size_t count = 0;  ///< clusters
    double slack = 0;       ///< mm: what single precision may hide in a coordinate here
    bool complete = true;   ///< false: there were more than `limit` clusters, or more than there is room for
};

/// Finds what is near a tool while it moves within a skin from `toolInTooth`: clusters whose triangles the tool could
/// bring together, and some that it could not. Looks into no more of the tooth's tree than it is asked for.
class BvhTraversal {
public:
    /// Begins with the whole of `surface`, none of which has been looked into. Surface and tool must outlive the walk.
    void begin(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth,
               const ContactMargin& contactMargin, NearClusters& out);
    /// Looks into a child of one of the nodes found: what may be near of it is found, to close it is the caller's.
    /// Gives up (out.complete) beyond `limit` clusters.
    void open(const NearNode& node, int child, std::size_t limit, NearClusters& out) const;

    /// The slab between a leaf among the children of a node and the whole tool along a direction: its width, mm.
    [[nodiscard]] float gapAlong(std::size_t node, int child, const SupportPlanes::Plane& side,
                                 const NearClusters& out) const;

private:
    [[nodiscard]] broadphase::Boxf boxAround(const AabbTree::Node& node) const;
    [[nodiscard]] bool meetsTool(const broadphase::Boxf& box, AabbTree::Link link) const;
    [[nodiscard]] const AabbTree& treeOf(std::uint32_t part) const;
    void addNode(std::uint32_t part, const AabbTree::Node& node, std::optional<SupportPlanes::Number> side,
                 NearClusters& out) const;
    [[nodiscard]] broadphase::Box8 turned(const AabbTree::Node& node) const;
    [[nodiscard]] std::uint32_t findSlabs(const AabbTree::Node& node, SupportPlanes::Number side, std::uint32_t near,
                                          float slack, NearNode& found) const;

    const Surface* surface_ = nullptr;
    const ToolShape* tool_ = nullptr;
    broadphase::FrameTransform turn_{};
    Eigen::Matrix3f toTooth_ = Eigen::Matrix3f::Identity();
    Vec3f origin_ = Vec3f::Zero();  ///< of the tool, in the tooth's frame
    broadphase::TranslationBounds translations_;
    float chord_ = 0;  ///< of the skin, a chord
    std::span<const float> losses_;
};

}  // namespace tactooth
