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

/// Eight clusters. A cluster is a leaf of the tooth, one triangle of the tool, and a slab between them. Along `normal`
/// (tool's frame, length at most 1, from tooth to tool) they are `gap` mm apart; negative: they overlap by so much.
struct alignas(32) ClusterPacket {
    float normal[3][8];
    float gap[8];
    float centre[3][8];  ///< ball around the tool's triangle, mm
    float radius[8];
    std::uint32_t leaf[8];  ///< index in `leaves`
    std::uint32_t tool[8];  ///< triangle of the tool
};

/// The children of a node of the tooth's tree that may be near and are not opened yet. Each has a slab between it and
/// the whole tool, in the tool's frame like those of clusters.
struct alignas(32) NearNode {
    float normal[3][8];
    float gap[8];
    float loss[8];  ///< how much a rotation may reduce the gap, mm per chord
    AabbTree::Link child[8];
    SupportPlanes::Number plane[8];  ///< support plane of the tool that faces the child
    std::uint32_t part;
    std::uint32_t closed;  ///< one bit for each child that may be near and is not opened
    std::uint32_t exact;   ///< one bit for each leaf whose gap was computed from its triangles, not from its disc
};

/// The nodes, leaves and clusters near a tool. Fixed memory: filling it allocates nothing.
struct NearClusters {
    explicit NearClusters(std::size_t capacity) : nodes(capacity / 8), leaves(capacity / 4), packets(capacity / 8) {}

    [[nodiscard]] std::size_t capacity() const { return packets.size() * 8; }

    std::vector<NearNode> nodes;
    std::vector<NearLeaf> leaves;
    std::vector<ClusterPacket> packets;
    std::size_t nodeCount = 0;
    std::size_t leafCount = 0;
    std::size_t count = 0;  ///< clusters
    double slack = 0;       ///< largest error of a coordinate in single precision here, mm
    bool complete = true;   ///< false: there were more than `limit` clusters, or more than there is room for
};

/// Finds the clusters near a tool that moves within a contact margin from `toolInTooth`: all clusters whose triangles
/// the motion could bring together, and some others. Opens only the nodes of the tooth's tree that the caller asks for.
class BvhTraversal {
public:
    /// Begins with the roots of all parts of `surface`, not opened. Surface and tool must outlive the traversal.
    void begin(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth,
               const ContactMargin& contactMargin, NearClusters& out);
    /// Opens a child of a node: appends its nodes or clusters that may be near. The caller clears the child's bit in
    /// `closed`. Beyond `limit` clusters it stops and clears out.complete.
    void open(const NearNode& node, int child, std::size_t limit, NearClusters& out) const;

    /// The width of the slab between a leaf (a child of a node) and the whole tool along a support plane, mm.
    [[nodiscard]] float gapAlong(std::size_t node, int child, const SupportPlanes::Plane& plane,
                                 const NearClusters& out) const;

private:
    [[nodiscard]] broadphase::Boxf boxAround(const AabbTree::Node& node) const;
    [[nodiscard]] bool meetsTool(const broadphase::Boxf& box, AabbTree::Link link) const;
    [[nodiscard]] const AabbTree& treeOf(std::uint32_t part) const;
    void addNode(std::uint32_t part, const AabbTree::Node& node, std::optional<SupportPlanes::Number> plane,
                 NearClusters& out) const;
    [[nodiscard]] broadphase::Box8 turned(const AabbTree::Node& node) const;
    [[nodiscard]] std::uint32_t findSlabs(const AabbTree::Node& node, SupportPlanes::Number plane, std::uint32_t near,
                                          float slack, NearNode& found) const;

    const Surface* surface_ = nullptr;
    const ToolShape* tool_ = nullptr;
    broadphase::FrameTransform turn_{};
    Eigen::Matrix3f toTooth_ = Eigen::Matrix3f::Identity();
    Vec3f origin_ = Vec3f::Zero();  ///< of the tool, in the tooth's frame
    broadphase::TranslationBounds translations_;
    float chord_ = 0;  ///< rotation of the contact margin
    std::span<const float> losses_;
};

}  // namespace tactooth
