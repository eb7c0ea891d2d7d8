// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Private to near_clusters.cpp.

#include <algorithm>
#include <bit>
#include <cmath>

#include "collision/neighbours/near_clusters.h"
#include "geometry/util/assert.h"

namespace tactooth::broadphase {

/// Opens a leaf of the tooth: finds the triangles of the tool that may come near, and a slab for each.
class LeafTraversal {
public:
    LeafTraversal(const ToolShape& tool, const TriangleMask* hidden, std::uint32_t part, const FrameTransform& turn,
                  const TranslationBounds& shifts, float chord, std::size_t limit, NearClusters& out)
        : tool_(tool),
          toolTree_(tool.part().tree()),
          hidden_(hidden),
          part_(part),
          turn_(turn),
          translations_(shifts),
          chord_(Float8::all(chord)),
          limit_(std::min(limit, out.capacity())),
          out_(out) {
        TACTOOTH_ASSERT(chord >= 0);
    }

    /// Appends the clusters of a leaf.
    void visitLeaf(const AabbTree::Leaf& leaf) {
        TransformedLeaf tooth(leaf, turn_, translations_);
        visitBelow(tooth, {toolTree_.rootLink().index(), 0xFF});
    }

private:
    /// Children of one of the tool's nodes that may be near.
    struct Candidates {
        std::uint32_t node;
        std::uint32_t children;  // one bit each
    };

    /// One bit for each child of a node of the tool whose box overlaps `box`.
    [[nodiscard]] std::uint32_t meeting(AabbTree::Link link, const AabbTree::Node& node, const Boxf& box) const {
        const Float8 grow = Float8::load(tool_.far(link).data()) * chord_;
        return overlaps({Vec3x8::load(node.low), Vec3x8::load(node.high)}, grow, box);
    }

    void visitBelow(TransformedLeaf& tooth, const Candidates& candidates) {
        const AabbTree::Link link = AabbTree::Link::toNode(candidates.node);
        const AabbTree::Node& node = toolTree_.node(link);
        std::uint32_t hits = meeting(link, node, tooth.grown) & candidates.children;
        for (; hits != 0; hits &= hits - 1) {
            const AabbTree::Link child = node.child[std::countr_zero(hits)];
            if (child.isLeaf()) {
                meet(tooth, child);
            } else {
                visitBelow(tooth, {child.index(), 0xFF});
            }
        }
    }

    /// Writes the clusters of a leaf of the tooth and the triangles of a leaf of the tool. Cheap tests come first.
    void meet(TransformedLeaf& tooth, AabbTree::Link toolLink) {
        const AabbTree::Leaf& toolLeaf = toolTree_.leaf(toolLink);
        const ToolShape::Faces& faces = tool_.faces(toolLink);
        std::uint32_t near = facesNear(tooth, faces) & ((1U << toolLeaf.count) - 1U);
        if (near == 0) return;
        if (!tooth.isKept && !keep(tooth)) return;
        const Extent& mean = tooth.bySum;
        const Vec3x8 n = Vec3x8::all(mean.direction.x(), mean.direction.y(), mean.direction.z());
        const Float8 a = dot(n, Vec3x8::load(toolLeaf.corner[0]));
        const Float8 b = dot(n, Vec3x8::load(toolLeaf.corner[1]));
        const Float8 c = dot(n, Vec3x8::load(toolLeaf.corner[2]));
        float front[8], behind[8], rotationSlack[8];
        const Float8 rotationSlack8 = Float8::load(faces.far) * chord_;
        const Float8 front8 = min(min(a, b), c) - Float8::all(mean.high);
        const Float8 behind8 = Float8::all(mean.low) - max(max(a, b), c);
        near &= ~(lessEqual(Float8::all(translations_.closing(mean.direction)) + rotationSlack8, front8) |
                  lessEqual(Float8::all(translations_.closing(-mean.direction)) + rotationSlack8, behind8));
        if (near == 0) return;
        front8.store(front), behind8.store(behind), rotationSlack8.store(rotationSlack);
        // The triangles of a flat leaf are hardly further away than the leaf: to test each costs more than it saves.
        const bool isFlat = mean.high - mean.low < translations_.around;
        for (; near != 0; near &= near - 1) {
            const int k = std::countr_zero(near);
            Slab slab{mean.direction, front[k]};
            widen(slab, {-mean.direction, behind[k]});
            const Slab byTool = byFace(tooth, faces, k);
            if (staysOpen(byTool, rotationSlack[k])) continue;
            const Slab apart = byBoxes(tooth.box, faces, k);
            if (staysOpen(apart, rotationSlack[k])) continue;
            if (!isFlat && !isAnyNear(tooth, toolLeaf, faces, k, rotationSlack[k])) continue;
            widen(slab, byTool);
            widen(slab, apart);
            write(slab, toolLeaf.triangle[k]);
        }
    }

    /// One bit for each of the tool's triangles whose box and plane may both meet the box of the leaf.
    [[nodiscard]] std::uint32_t facesNear(const TransformedLeaf& tooth, const ToolShape::Faces& faces) const {
        const Float8 rotationSlack = Float8::load(faces.far) * chord_;
        const std::uint32_t boxes =
            overlaps({Vec3x8::load(faces.low), Vec3x8::load(faces.high)}, rotationSlack, tooth.grown);
        if (boxes == 0) return 0;
        const Vec3x8 low = Vec3x8::all(tooth.box.low[0], tooth.box.low[1], tooth.box.low[2]);
        const Vec3x8 high = Vec3x8::all(tooth.box.high[0], tooth.box.high[1], tooth.box.high[2]);
        const Vec3x8 n = Vec3x8::load(faces.normal);
        const Float8 ax = n.x * low.x, bx = n.x * high.x;
        const Float8 ay = n.y * low.y, by = n.y * high.y;
        const Float8 az = n.z * low.z, bz = n.z * high.z;
        const Float8 nearest = min(ax, bx) + min(ay, by) + min(az, bz);
        const Float8 farthest = max(ax, bx) + max(ay, by) + max(az, bz);
        const Float8 along = dot(n, broadcast(translations_.along));
        const Float8 around = Float8::all(translations_.around) + rotationSlack;
        const Float8 zero = Float8::all(0);
        return boxes & lessEqual(nearest, Float8::load(faces.highOffset) + max(along, zero) + around) &
               lessEqual(Float8::load(faces.lowOffset) + min(along, zero) - around, farthest);
    }

    struct Slab {
        Vec3f normal;
        float gap;
    };

    /// Whether no motion within the contact margin can close the slab.
    [[nodiscard]] bool staysOpen(const Slab& slab, float rotationSlack) const {
        return slab.gap > translations_.closing(slab.normal) + rotationSlack;
    }

    /// Takes the slab that stays wider on the expected motion. The wider one at its start may lie right across it.
    void widen(Slab& slab, const Slab& other) const {
        const auto remaining = [&](const Slab& one) { return one.gap - translations_.closing(one.normal); };
        if (remaining(other) > remaining(slab)) slab = other;
    }

    /// Whether any triangle of the tooth's leaf may meet the tool's triangle `k`, if the leaf as a whole may. A leaf
    /// that is not flat, as in a groove, fills far more space than its triangles.
    [[nodiscard]] bool isAnyNear(const TransformedLeaf& tooth, const AabbTree::Leaf& toolLeaf,
                                 const ToolShape::Faces& faces, int k, float rotationSlack) const {
        const Vec3x8 &p = tooth.corner[0], &q = tooth.corner[1], &r = tooth.corner[2];
        const auto boxes =
            Box8{min(min(p, q), r) - broadcast(translations_.high), max(max(p, q), r) - broadcast(translations_.low)};
        const Boxf box{{faces.low[0][k], faces.low[1][k], faces.low[2][k]},
                       {faces.high[0][k], faces.high[1][k], faces.high[2][k]}};
        std::uint32_t near = tooth.present & overlaps(boxes, Float8::all(rotationSlack), box);
        if (near == 0) return false;
        const Float8 around = Float8::all(translations_.around + rotationSlack);
        const auto separated = [&](const Vec3x8& n, Float8 toolLow, Float8 toolHigh) {
            const Float8 a = dot(n, p), b = dot(n, q), c = dot(n, r);
            const Float8 along = dot(n, broadcast(translations_.along));
            const Float8 zero = Float8::all(0);
            return lessEqual(max(max(a, b), c) + around, toolLow + min(along, zero)) |
                   lessEqual(toolHigh + max(along, zero) + around, min(min(a, b), c));
        };
        const Vec3x8 face = Vec3x8::all(faces.normal[0][k], faces.normal[1][k], faces.normal[2][k]);
        near &= ~separated(face, Float8::all(faces.lowOffset[k]), Float8::all(faces.highOffset[k]));
        const auto lane = [&](int i) {
            return Vec3x8::all(toolLeaf.corner[i][0][k], toolLeaf.corner[i][1][k], toolLeaf.corner[i][2][k]);
        };
        const Float8 a = dot(tooth.normal, lane(0)), b = dot(tooth.normal, lane(1)), c = dot(tooth.normal, lane(2));
        return (near & ~separated(tooth.normal, min(min(a, b), c), max(max(a, b), c))) != 0;
    }

    static Slab byFace(const TransformedLeaf& tooth, const ToolShape::Faces& faces, int k) {
        const Vec3f normal(faces.normal[0][k], faces.normal[1][k], faces.normal[2][k]);
        const Extent extent = extentOf(tooth.corner, normal);
        const float front = faces.lowOffset[k] - extent.high;
        const float behind = extent.low - faces.highOffset[k];
        return front >= behind ? Slab{normal, front} : Slab{-normal, behind};
    }

    /// The slab between two boxes; of width 0 if they overlap.
    static Slab byBoxes(const Boxf& box, const ToolShape::Faces& faces, int k) {
        Vec3f between;
        for (int axis = 0; axis < 3; ++axis) {
            between[axis] = std::max(faces.low[axis][k] - box.high[axis], 0.0F) -
                            std::max(box.low[axis] - faces.high[axis][k], 0.0F);
        }
        const float gap = between.norm();
        return gap > 0 ? Slab{between / gap, gap} : Slab{Vec3f::Zero(), 0};
    }

    /// Writes the leaf. False if there is no room for it, or if all its triangles are hidden.
    bool keep(TransformedLeaf& tooth) {
        std::uint32_t& present = tooth.present = (1U << tooth.leaf->count) - 1U;
        for (std::uint32_t i = 0; hidden_ != nullptr && i < tooth.leaf->count; ++i) {
            if (isHidden(*hidden_, tooth.leaf->triangle[i])) present &= ~(1U << i);
        }
        if (present == 0) return false;
        if (out_.leafCount == out_.leaves.size()) return out_.complete = false;
        NearLeaf& kept = out_.leaves[out_.leafCount++];
        for (int i = 0; i < 3; ++i) tooth.corner[i].store(kept.corner[i]);
        std::copy_n(tooth.leaf->triangle, AabbTree::kWidth, kept.triangle);
        kept.part = part_;
        kept.present = present;
        tooth.findNormals();
        tooth.normal.store(kept.normal);
        return tooth.isKept = true;
    }

    void write(const Slab& slab, std::uint32_t tool) {
        if (out_.count == limit_) {
            out_.complete = false;
            return;
        }
        TACTOOTH_ASSERT(out_.count < limit_ && out_.leafCount > 0);
        TACTOOTH_ASSERT(std::isfinite(slab.gap));
        ClusterPacket& packet = out_.packets[out_.count / 8];
        const std::size_t lane = out_.count++ % 8;
        const ToolShape::Ball& ball = tool_.ball(tool);
        for (int axis = 0; axis < 3; ++axis) {
            packet.normal[axis][lane] = slab.normal[axis];
            packet.centre[axis][lane] = ball.centre[axis];
        }
        packet.gap[lane] = slab.gap - static_cast<float>(out_.slack);
        packet.radius[lane] = ball.radius;
        packet.leaf[lane] = static_cast<std::uint32_t>(out_.leafCount - 1);
        packet.tool[lane] = tool;
    }

    const ToolShape& tool_;
    const AabbTree& toolTree_;
    const TriangleMask* hidden_;
    std::uint32_t part_;
    const FrameTransform& turn_;
    const TranslationBounds& translations_;
    Float8 chord_;
    std::size_t limit_;
    NearClusters& out_;
};

}  // namespace tactooth::broadphase
