// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/neighbours/near_clusters.h"

#include <bit>
#include <cmath>
#include <limits>

#include "collision/neighbours/leaf_traversal.h"
#include "geometry/util/assert.h"

// Simultaneous descent of two trees: G. van den Bergen, "Efficient Collision Detection of Complex Deformable Models
// using AABB Trees", J. Graphics Tools 2(4), 1997. Differs from the paper: the traversal is in the tool's frame. Only
// the tooth's boxes and triangles that it reaches are transformed, eight at a time; the tool's boxes never are.
//
// The traversal continues on demand from the front that it has reached: T.-Y. Li, J.-S. Chen, "Incremental 3D Collision
// Detection with Hierarchical Data Structures", VRST 1998. Differs from the paper: near a contact, a disc around a
// branch of the tooth and a support plane of the tool separate most branches from the whole tool at once. The traversal
// ends at a leaf of the tooth against a triangle of the tool. The pairs of their triangles are tested later, if at all
// (see NeighbourList).

namespace tactooth {
namespace {

using namespace broadphase;

// The error of a node's slab, in slacks of a coordinate: it is computed in the tooth's frame, far from the origin.
constexpr double kNodeSlacks = 3;

/// The error of single precision: a few rounding steps of the largest number in a traversal, mm.
double roundingSlack(const SurfacePart& tooth, const ToolShape& tool, const Pose& toolInTooth) {
    const Box3& box = tooth.tree().box();
    const double largest = std::max({box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff(),
                                     toolInTooth.position.cwiseAbs().maxCoeff(), tool.radius()});
    return 8 * std::numeric_limits<float>::epsilon() * largest;
}

}  // namespace

/// The boxes of a tooth node in the tool's frame, grown by the shifts of the contact margin.
Box8 BvhTraversal::turned(const AabbTree::Node& node) const {
    const Vec3x8 low = Vec3x8::load(node.low);
    const Vec3x8 high = Vec3x8::load(node.high);
    const Float8 half = Float8::all(0.5F);
    const Vec3x8 sum = low + high;
    const Vec3x8 difference = high - low;
    const Vec3x8 centre = turn_.point({sum.x * half, sum.y * half, sum.z * half});
    const Vec3x8 halfSize = {difference.x * half, difference.y * half, difference.z * half};
    const Vec3x8 extent = {dot(turn_.absolute[0], halfSize), dot(turn_.absolute[1], halfSize),
                           dot(turn_.absolute[2], halfSize)};
    return {centre - extent - broadcast(translations_.high), centre + extent - broadcast(translations_.low)};
}

/// Finds the slabs between the tool and the children in `near`, along a support plane and those with similar normals.
/// Returns the children whose slab the contact margin may close.
std::uint32_t BvhTraversal::findSlabs(const AabbTree::Node& node, SupportPlanes::Number plane, std::uint32_t near,
                                      float slack, NearNode& found) const {
    const SupportPlanes& planes = tool_->supportPlanes();
    TACTOOTH_ASSERT(plane < planes.size());
    const Vec3x8 centre = turn_.point(Vec3x8::load(node.centre));
    const Vec3x8 normal = turn_.direction(Vec3x8::load(node.normal));
    const Float8 zero = Float8::all(0);
    Float8 furthest = Float8::all(-std::numeric_limits<float>::infinity());
    Float8 place = zero;
    Vec3x8 inward = Vec3x8::all(0, 0, 0);
    const SupportPlanes::Neighbours& similar = planes.similarTo(plane);
    for (int i = 0; i < SupportPlanes::kNeighbours; ++i) {
        const SupportPlanes::Plane& candidate = planes[similar[i]];
        const Vec3x8 d = broadcast(candidate.inward);
        const Float8 beyond = Float8::all(candidate.low) - dot(d, centre);
        const auto wider = [&](Float8 mine, Float8 its) { return whereLess(furthest, beyond, its, mine); };
        inward = {wider(inward.x, d.x), wider(inward.y, d.y), wider(inward.z, d.z)};
        place = wider(place, Float8::all(static_cast<float>(i)));
        furthest = max(furthest, beyond);
    }
    const Float8 across = dot(inward, normal);
    const Float8 reach =
        max(across, zero - across) * Float8::load(node.halfThickness) +
        sqrt(max(Float8::all(1) - across * across, zero) + Float8::all(static_cast<float>(kFewRoundings))) *
            Float8::load(node.discRadius);
    const Float8 gap = furthest - reach - Float8::all(slack);
    inward.store(found.normal);
    gap.store(found.gap);
    float placed[8];
    place.store(placed);
    for (int i = 0; i < 8; ++i) {
        found.plane[i] = similar[static_cast<std::size_t>(placed[i])];
        found.loss[i] = losses_[found.plane[i]];
    }
    const Float8 closing =
        Float8::all(translations_.around) + max(zero - dot(inward, broadcast(translations_.along)), zero);
    return near & lessEqual(gap, closing + Float8::all(chord_) * Float8::load(found.loss));
}

void BvhTraversal::addNode(std::uint32_t part, const AabbTree::Node& node, std::optional<SupportPlanes::Number> plane,
                           NearClusters& out) const {
    const ToolShape::Bound& bound = tool_->bound(tool_->part().tree().rootLink());
    const std::uint32_t near = overlaps(turned(node), Float8::all(bound.far * chord_), bound);
    if (near == 0) return;
    if (out.nodeCount == out.nodes.size()) {
        out.complete = false;
        return;
    }
    if (!plane) {
        const Vec3x8 centre = turn_.point(Vec3x8::load(node.centre));
        float at[3][8];
        centre.store(at);
        const int i = std::countr_zero(near);
        plane = tool_->supportPlanes().facing({at[0][i], at[1][i], at[2][i]});
    }
    NearNode& found = out.nodes[out.nodeCount];
    found.closed = findSlabs(node, *plane, near, static_cast<float>(kNodeSlacks * out.slack), found);
    if (found.closed == 0) return;
    found.part = part;
    found.exact = 0;
    std::copy_n(node.child, AabbTree::kWidth, found.child);
    ++out.nodeCount;
}

/// A box in the tool's frame around all children of a node, grown by the shifts of the contact margin.
Boxf BvhTraversal::boxAround(const AabbTree::Node& node) const {
    // An absent child's box is inverted and infinite.
    Vec3f low, high;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = lowest(Float8::load(node.low[axis]));
        high[axis] = highest(Float8::load(node.high[axis]));
    }
    const Vec3f centre = toTooth_.transpose() * ((low + high) / 2 - origin_);
    const Vec3f extent = toTooth_.transpose().cwiseAbs() * ((high - low) / 2);
    Boxf box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = centre[axis] - extent[axis] - translations_.high[axis];
        box.high[axis] = centre[axis] + extent[axis] - translations_.low[axis];
    }
    return box;
}

/// Whether a box overlaps the box of any triangle below a node of the tool.
bool BvhTraversal::meetsTool(const Boxf& box, AabbTree::Link link) const {
    const AabbTree::Node& node = tool_->part().tree().node(link);
    const Float8 chord = Float8::all(chord_);
    const Float8 grow = Float8::load(tool_->far(link).data()) * chord;
    std::uint32_t hits = overlaps({Vec3x8::load(node.low), Vec3x8::load(node.high)}, grow, box);
    for (; hits != 0; hits &= hits - 1) {
        const AabbTree::Link child = node.child[std::countr_zero(hits)];
        if (!child.isLeaf()) {
            if (meetsTool(box, child)) return true;
            continue;
        }
        const ToolShape::Faces& faces = tool_->faces(child);
        if (overlaps({Vec3x8::load(faces.low), Vec3x8::load(faces.high)}, Float8::load(faces.far) * chord, box) != 0)
            return true;
    }
    return false;
}

const AabbTree& BvhTraversal::treeOf(std::uint32_t part) const {
    TACTOOTH_ASSERT(part <= surface_->patches.size());
    return part == 0 ? visibleBase(*surface_).tree : surface_->patches[part - 1]->tree();
}

float BvhTraversal::gapAlong(std::size_t node, int child, const SupportPlanes::Plane& plane,
                             const NearClusters& out) const {
    TACTOOTH_ASSERT(node < out.nodeCount);
    const NearNode& near = out.nodes[node];
    const AabbTree::Leaf& leaf = treeOf(near.part).leaf(near.child[child]);
    // It is cheaper to transform the direction than the leaf's many corners.
    const Vec3f& d = plane.inward;
    const Vec3f inTooth = toTooth_ * d;
    const Vec3x8 along = broadcast(inTooth);
    const Float8 a = dot(along, Vec3x8::load(leaf.corner[0]));
    const Float8 b = dot(along, Vec3x8::load(leaf.corner[1]));
    const Float8 c = dot(along, Vec3x8::load(leaf.corner[2]));
    const float high = highest(max(max(a, b), c)) - inTooth.dot(origin_);
    return plane.low - high - static_cast<float>(kNodeSlacks * out.slack);
}

void BvhTraversal::open(const NearNode& node, int child, std::size_t limit, NearClusters& out) const {
    TACTOOTH_ASSERT(surface_ != nullptr && tool_ != nullptr);
    const std::uint32_t part = node.part;
    const AabbTree::Link link = node.child[child];
    const AabbTree& tree = treeOf(part);
    if (!link.isLeaf()) {
        const AabbTree::Node& below = tree.node(link);
        if (meetsTool(boxAround(below), tool_->part().tree().rootLink())) addNode(part, below, node.plane[child], out);
        return;
    }
    LeafTraversal(*tool_, part == 0 ? visibleBase(*surface_).hidden : nullptr, part, turn_, translations_, chord_,
                  limit, out)
        .visitLeaf(tree.leaf(link));
}

void BvhTraversal::begin(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth,
                         const ContactMargin& contactMargin, NearClusters& out) {
    TACTOOTH_ASSERT(surface.base != nullptr);
    TACTOOTH_ASSERT(contactMargin.around >= 0 && contactMargin.turn >= 0);
    out.nodeCount = out.leafCount = out.count = 0;
    out.complete = true;
    surface_ = &surface;
    tool_ = &tool;
    if (surface.base->tree().empty() || tool.part().tree().empty()) return;
    out.slack = roundingSlack(*surface.base, tool, toolInTooth);
    turn_ = FrameTransform(toolInTooth);
    toTooth_ = toolInTooth.rotation.toRotationMatrix().cast<float>();
    origin_ = toolInTooth.position.cast<float>();
    translations_ = TranslationBounds(contactMargin, toolInTooth, out.slack);
    chord_ = static_cast<float>(contactMargin.turn);
    losses_ = tool.supportPlanes().losses(contactMargin.turn);
    const VisibleBase base = visibleBase(surface);
    if (!base.tree.empty()) addNode(0, base.tree.root(), {}, out);
    // A cheap ball test first: a cut tooth has hundreds of patches, and the tool is near a few of them.
    const Vec3 centre = toolInTooth * tool.centre();
    const double ball = tool.radius() + contactMargin.length() +
                        contactMargin.turn * (tool.centre().norm() + tool.radius()) + out.slack;
    for (std::size_t i = 0; i < surface.patches.size(); ++i) {
        const AabbTree& tree = surface.patches[i]->tree();
        if (tree.empty() || tree.box().squaredExteriorDistance(centre) > ball * ball) continue;
        addNode(static_cast<std::uint32_t>(i + 1), tree.root(), {}, out);
    }
}

}  // namespace tactooth
