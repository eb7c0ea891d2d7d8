// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/near_pairs.h"

#include <bit>

// Simultaneous descent of two trees: G. van den Bergen, "Efficient Collision Detection of Complex Deformable Models
// using AABB Trees", J. Graphics Tools 2(4), 1997. Differs from the paper: the walk happens in the tool's frame, into
// which only those tooth boxes and triangles are turned that it reaches, eight at a time; the tool's own boxes, which
// turn with the hand at every tick, are never touched.

namespace tactooth {
namespace {

struct Box8 {
    Vec3x8 low, high;
};

struct Boxf {
    float low[3], high[3];
};

/// One bit for each of the eight boxes that meets `other`.
std::uint32_t overlaps(const Box8& boxes, const Boxf& other) {
    return lessEqual(boxes.low.x, Float8::all(other.high[0])) & lessEqual(Float8::all(other.low[0]), boxes.high.x) &
           lessEqual(boxes.low.y, Float8::all(other.high[1])) & lessEqual(Float8::all(other.low[1]), boxes.high.y) &
           lessEqual(boxes.low.z, Float8::all(other.high[2])) & lessEqual(Float8::all(other.low[2]), boxes.high.z);
}

Box8 boxesOf(const AabbTree::Node& node) { return {Vec3x8::load(node.low), Vec3x8::load(node.high)}; }

/// Boxes spilled to memory, so that one of the eight can be picked.
struct Spilled {
    float low[3][8], high[3][8];

    explicit Spilled(const Box8& boxes) {
        boxes.low.x.store(low[0]), boxes.low.y.store(low[1]), boxes.low.z.store(low[2]);
        boxes.high.x.store(high[0]), boxes.high.y.store(high[1]), boxes.high.z.store(high[2]);
    }
    [[nodiscard]] Boxf pick(int i) const {
        return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
    }
};

/// Eight tooth triangles in the tool's frame.
struct TurnedLeaf {
    std::uint32_t index = UINT32_MAX;  // of the leaf in its tree
    Vec3x8 corner[3];
    Vec3x8 normal;
    Box8 box;  // of each triangle
    Boxf whole;
};

/// Rotation and translation from the tooth's frame to the tool's, in single precision.
struct Turn {
    Vec3x8 row[3];       // rows of the rotation, each component broadcast
    Vec3x8 absolute[3];  // their absolute values
    Vec3x8 origin;       // the tool's origin in the tooth's frame

    Turn(const Pose& toolInTooth) {
        const Eigen::Matrix3f rotation = toolInTooth.rotation.toRotationMatrix().transpose().cast<float>();
        for (int i = 0; i < 3; ++i) {
            row[i] = Vec3x8::all(rotation(i, 0), rotation(i, 1), rotation(i, 2));
            absolute[i] = Vec3x8::all(std::abs(rotation(i, 0)), std::abs(rotation(i, 1)), std::abs(rotation(i, 2)));
        }
        const Vec3f p = toolInTooth.position.cast<float>();
        origin = Vec3x8::all(p.x(), p.y(), p.z());
    }
    [[nodiscard]] Vec3x8 point(const Vec3x8& p) const {
        const Vec3x8 q = p - origin;
        return {dot(row[0], q), dot(row[1], q), dot(row[2], q)};
    }
};

class Walk {
public:
    Walk(const ToolShape& tool, const Pose& toolInTooth, float reach, float slack, std::span<NearPair> out)
        : tool_(tool), toolTree_(tool.part().tree()), turn_(toolInTooth), reach_(reach), slack_(slack), out_(out) {}

    void run(std::uint32_t part, const SurfacePart& tooth, const TriangleMask* hidden) {
        part_ = part;
        toothTree_ = &tooth.tree();
        hidden_ = hidden;
        leaf_.index = UINT32_MAX;
        if (toothTree_->empty() || toolTree_.empty()) return;
        const Box3& box = toolTree_.box();
        Boxf whole;
        for (int axis = 0; axis < 3; ++axis) {
            whole.low[axis] = static_cast<float>(box.min()[axis]);
            whole.high[axis] = static_cast<float>(box.max()[axis]);
        }
        descendTooth(toothTree_->root(), AabbTree::Link::toNode(0), whole);
    }

    [[nodiscard]] NearPairsFound found() const { return {count_, complete_}; }

private:
    /// Boxes of a tooth node in the tool's frame, grown by the reach.
    [[nodiscard]] Box8 turned(const AabbTree::Node& node) const {
        const Vec3x8 low = Vec3x8::load(node.low);
        const Vec3x8 high = Vec3x8::load(node.high);
        const Float8 half = Float8::all(0.5F);
        const Vec3x8 sum = low + high;
        const Vec3x8 difference = high - low;
        const Vec3x8 centre = turn_.point({sum.x * half, sum.y * half, sum.z * half});
        const Vec3x8 halfSize = {difference.x * half, difference.y * half, difference.z * half};
        const Float8 grow = Float8::all(reach_ + slack_);
        const Vec3x8 extent = {dot(turn_.absolute[0], halfSize) + grow, dot(turn_.absolute[1], halfSize) + grow,
                               dot(turn_.absolute[2], halfSize) + grow};
        return {centre - extent, centre + extent};
    }

    /// Tooth node against the tool's sub-tree `toolLink` with box `toolBox`.
    void descendTooth(const AabbTree::Node& node, AabbTree::Link toolLink, const Boxf& toolBox) {
        const Box8 boxes = turned(node);
        std::uint32_t hits = overlaps(boxes, toolBox);
        if (hits == 0) return;
        const Spilled spilled(boxes);
        for (; hits != 0; hits &= hits - 1) {
            const int i = std::countr_zero(hits);
            descendTool(node.child[i], spilled.pick(i), toolLink, toolBox);
        }
    }

    /// Tooth sub-tree `toothLink` with (grown) box `toothBox` against the children of the tool's `toolLink`.
    void descendTool(AabbTree::Link toothLink, const Boxf& toothBox, AabbTree::Link toolLink, const Boxf& toolBox) {
        if (toolLink.isLeaf()) {
            if (toothLink.isLeaf()) {
                meet(turnedLeaf(toothLink), toolTree_.leaf(toolLink));
            } else {
                descendTooth(toothTree_->node(toothLink), toolLink, toolBox);
            }
            return;
        }
        const AabbTree::Node& node = toolTree_.node(toolLink);
        const Box8 boxes = boxesOf(node);
        const Boxf& reached = toothLink.isLeaf() ? turnedLeaf(toothLink).whole : toothBox;
        std::uint32_t hits = overlaps(boxes, reached);
        for (; hits != 0; hits &= hits - 1) {
            const int i = std::countr_zero(hits);
            const Boxf childBox = {{node.low[0][i], node.low[1][i], node.low[2][i]},
                                   {node.high[0][i], node.high[1][i], node.high[2][i]}};
            if (toothLink.isLeaf()) {
                descendTool(toothLink, toothBox, node.child[i], childBox);
            } else {
                descendTooth(toothTree_->node(toothLink), node.child[i], childBox);
            }
        }
    }

    [[nodiscard]] const TurnedLeaf& turnedLeaf(AabbTree::Link link) {
        if (leaf_.index == link.index()) return leaf_;
        const AabbTree::Leaf& leaf = toothTree_->leaf(link);
        leaf_.index = link.index();
        for (int corner = 0; corner < 3; ++corner)
            leaf_.corner[corner] = turn_.point(Vec3x8::load(leaf.corner[corner]));
        leaf_.box = {min(min(leaf_.corner[0], leaf_.corner[1]), leaf_.corner[2]),
                     max(max(leaf_.corner[0], leaf_.corner[1]), leaf_.corner[2])};
        leaf_.normal = unitNormals(leaf_.corner);
        const Spilled spilled(leaf_.box);
        for (int axis = 0; axis < 3; ++axis) {
            const float grow = reach_ + slack_;
            leaf_.whole.low[axis] = *std::min_element(spilled.low[axis], spilled.low[axis] + 8) - grow;
            leaf_.whole.high[axis] = *std::max_element(spilled.high[axis], spilled.high[axis] + 8) + grow;
        }
        return leaf_;
    }

    /// Unit normals; a triangle without area gets a short vector, whose slab widths are short too: still a bound.
    static Vec3x8 unitNormals(const Vec3x8 (&corner)[3]) {
        const Vec3x8 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
        const Float8 length = max(sqrt(dot(normal, normal)), Float8::all(1e-30F));
        return {normal.x / length, normal.y / length, normal.z / length};
    }

    /// Lower bounds for the distances of one tool triangle to eight tooth triangles.
    struct Bounds {
        Float8 boxes;      // of the slab between the boxes
        Float8 alongTool;  // of the slabs along the two normals
        Float8 alongTooth;
    };

    /// Writes the pairs of eight tooth triangles with up to eight tool triangles that no cheap test separates.
    void meet(const TurnedLeaf& tooth, const AabbTree::Leaf& toolLeaf) {
        const AabbTree::Leaf& toothLeaf = toothTree_->leaf(AabbTree::Link::toLeaf(tooth.index));
        const std::uint32_t present = (1U << toothLeaf.count) - 1U;
        for (std::uint32_t k = 0; k < toolLeaf.count; ++k) {
            const Bounds bounds = distanceBounds(tooth, toolLeaf, k);
            const Float8 best = max(bounds.boxes, max(bounds.alongTool, bounds.alongTooth)) - Float8::all(slack_);
            std::uint32_t hits = lessEqual(best, Float8::all(reach_)) & present;
            if (hits == 0) continue;
            const std::uint32_t byTool = lessEqual(bounds.alongTooth, bounds.alongTool);
            float distances[8];
            best.store(distances);
            for (; hits != 0; hits &= hits - 1) {
                const int lane = std::countr_zero(hits);
                write(toothLeaf.triangle[lane], toolLeaf.triangle[k], distances[lane], ((byTool >> lane) & 1U) != 0);
            }
        }
    }

    [[nodiscard]] Bounds distanceBounds(const TurnedLeaf& tooth, const AabbTree::Leaf& toolLeaf,
                                        std::uint32_t k) const {
        Vec3x8 tool[3];
        for (int corner = 0; corner < 3; ++corner) {
            tool[corner] = Vec3x8::all(toolLeaf.corner[corner][0][k], toolLeaf.corner[corner][1][k],
                                       toolLeaf.corner[corner][2][k]);
        }
        const Vec3x8 low = min(min(tool[0], tool[1]), tool[2]);
        const Vec3x8 high = max(max(tool[0], tool[1]), tool[2]);
        const Vec3x8 gap = max(max(tooth.box.low - high, low - tooth.box.high), Vec3x8::all(0, 0, 0));
        const Vec3f& n = tool_.normal(toolLeaf.triangle[k]);
        return {sqrt(dot(gap, gap)), slab(Vec3x8::all(n.x(), n.y(), n.z()), tool, tooth.corner),
                slab(tooth.normal, tool, tooth.corner)};
    }

    static Float8 slab(const Vec3x8& normal, const Vec3x8 (&a)[3], const Vec3x8 (&b)[3]) {
        const Float8 a0 = dot(normal, a[0]);
        const Float8 a1 = dot(normal, a[1]);
        const Float8 a2 = dot(normal, a[2]);
        const Float8 b0 = dot(normal, b[0]);
        const Float8 b1 = dot(normal, b[1]);
        const Float8 b2 = dot(normal, b[2]);
        return max(min(min(b0, b1), b2) - max(max(a0, a1), a2), min(min(a0, a1), a2) - max(max(b0, b1), b2));
    }

    void write(std::uint32_t toothTriangle, std::uint32_t toolTriangle, float bound, bool toolFaceParts) {
        if (hidden_ != nullptr && isHidden(*hidden_, toothTriangle)) return;
        if (count_ == out_.size()) {
            complete_ = false;
            return;
        }
        out_[count_++] = {part_, toothTriangle, toolTriangle, std::max(bound, 0.0F), toolFaceParts};
    }

    const ToolShape& tool_;
    const AabbTree& toolTree_;
    const AabbTree* toothTree_ = nullptr;
    const TriangleMask* hidden_ = nullptr;
    std::uint32_t part_ = 0;
    Turn turn_;
    float reach_;
    float slack_;
    std::span<NearPair> out_;
    std::size_t count_ = 0;
    bool complete_ = true;
    TurnedLeaf leaf_;
};

/// What single precision can hide: a few rounding steps of the largest number that a walk handles, mm.
double roundingSlack(const SurfacePart& tooth, const ToolShape& tool, const Pose& toolInTooth) {
    const Box3& box = tooth.tree().box();
    const double largest = std::max({box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff(),
                                     toolInTooth.position.cwiseAbs().maxCoeff(), tool.radius()});
    return 8 * std::numeric_limits<float>::epsilon() * largest;
}

}  // namespace

NearPairsFound findNearPairs(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth, double reach,
                             std::span<NearPair> out) {
    if (surface.base->tree().empty()) return {};
    const double slack = roundingSlack(*surface.base, tool, toolInTooth);
    Walk walk(tool, toolInTooth, static_cast<float>(reach), static_cast<float>(slack), out);
    walk.run(0, *surface.base, surface.hidden.get());
    // A cheap ball test first: cutting leaves hundreds of patches, of which the tool is near a handful.
    const Vec3 centre = toolInTooth * tool.centre();
    const double ball = tool.radius() + reach + slack;
    for (std::size_t i = 0; i < surface.patches.size(); ++i) {
        const AabbTree& tree = surface.patches[i]->tree();
        if (tree.empty() || tree.box().squaredExteriorDistance(centre) > ball * ball) continue;
        walk.run(static_cast<std::uint32_t>(i + 1), *surface.patches[i], nullptr);
    }
    return walk.found();
}

}  // namespace tactooth
