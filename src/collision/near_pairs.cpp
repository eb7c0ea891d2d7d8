// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/near_pairs.h"

#include <bit>

// Simultaneous descent of two trees: G. van den Bergen, "Efficient Collision Detection of Complex Deformable Models
// using AABB Trees", J. Graphics Tools 2(4), 1997. Differs from the paper: the walk happens in the tool's frame, into
// which only those tooth boxes and triangles are turned that it reaches, eight at a time; the tool's own boxes, which
// turn with the hand at every tick, are never touched. And no tooth node is visited twice: it carries along all of the
// tool's nodes that are in question, each level of the tooth narrowing them.

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

    Spilled() = default;
    explicit Spilled(const Box8& boxes) {
        boxes.low.x.store(low[0]), boxes.low.y.store(low[1]), boxes.low.z.store(low[2]);
        boxes.high.x.store(high[0]), boxes.high.y.store(high[1]), boxes.high.z.store(high[2]);
    }
    [[nodiscard]] Boxf pick(int i) const {
        return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
    }
};

/// The box of eight boxes, grown.
Boxf wholeOf(const Spilled& boxes, float grow) {
    Boxf whole;
    for (int axis = 0; axis < 3; ++axis) {
        const auto& low = boxes.low[axis];
        const auto& high = boxes.high[axis];
        whole.low[axis] = *std::min_element(low, low + 8) - grow;
        whole.high[axis] = *std::max_element(high, high + 8) + grow;
    }
    return whole;
}

/// Eight tooth triangles in the tool's frame.
struct TurnedLeaf {
    const AabbTree::Leaf* leaf;
    std::uint32_t present;  // one bit for each triangle that is there
    Vec3x8 corner[3];
    Vec3x8 normal;
    Box8 box;                 // of each triangle
    Spilled spilled;          // the same
    float normalLanes[3][8];  // of each triangle
    Boxf whole;               // grown by the reach
};

/// Signed widths of the slabs between eight pairs of triangles along one normal a pair; at most one is positive.
struct Slabs {
    Float8 toolInFront;  // the tooth behind, the tool in front
    Float8 toolBehind;
    [[nodiscard]] Float8 width() const { return max(toolInFront, toolBehind); }
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
        if (toothTree_->empty() || toolTree_.empty()) return;
        const Suspects all{0, 0xFF};
        descend(toothTree_->root(), {&all, 1});
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

    /// Children of one of the tool's nodes that may be near.
    struct Suspects {
        std::uint32_t node;
        std::uint32_t children;  // one bit each
    };
    using Front = std::span<const Suspects>;

    /// Tooth node against the part of the tool that `front` names.
    void descend(const AabbTree::Node& node, Front front) {
        const Spilled boxes(turned(node));
        for (int i = 0; i < AabbTree::kWidth && node.low[0][i] <= node.high[0][i] && complete_; ++i) {
            const std::size_t mark = used_;
            const Front near = narrowed(front, boxes.pick(i));
            if (near.empty()) continue;
            if (node.child[i].isLeaf()) {
                meetLeaf(node.child[i], near);
            } else {
                descend(toothTree_->node(node.child[i]), near);
            }
            used_ = mark;
        }
    }

    /// What of `front` meets the box, one level further down the tool. If the stack is full, `front` itself.
    Front narrowed(Front front, const Boxf& box) {
        const std::size_t first = used_;
        for (const Suspects& suspects : front) {
            if (used_ + 1 + AabbTree::kWidth > stack_.size()) return front;
            const AabbTree::Node& node = toolTree_.node(AabbTree::Link::toNode(suspects.node));
            std::uint32_t leaves = overlaps(boxesOf(node), box) & suspects.children;
            for (std::uint32_t rest = leaves; rest != 0; rest &= rest - 1) {
                const int i = std::countr_zero(rest);
                if (node.child[i].isLeaf()) continue;
                stack_[used_++] = {node.child[i].index(), 0xFF};
                leaves &= ~(1U << i);
            }
            if (leaves != 0) stack_[used_++] = {suspects.node, leaves};
        }
        return Front(stack_).subspan(first, used_ - first);
    }

    void meetLeaf(AabbTree::Link toothLink, Front front) {
        const TurnedLeaf tooth = turnedLeaf(toothTree_->leaf(toothLink));
        for (const Suspects& suspects : front) meetBelow(tooth, suspects);
    }

    void meetBelow(const TurnedLeaf& tooth, const Suspects& suspects) {
        const AabbTree::Node& node = toolTree_.node(AabbTree::Link::toNode(suspects.node));
        std::uint32_t hits = overlaps(boxesOf(node), tooth.whole) & suspects.children;
        for (; hits != 0; hits &= hits - 1) {
            const AabbTree::Link child = node.child[std::countr_zero(hits)];
            if (child.isLeaf()) {
                meet(tooth, child);
            } else {
                meetBelow(tooth, {child.index(), 0xFF});
            }
        }
    }

    [[nodiscard]] TurnedLeaf turnedLeaf(const AabbTree::Leaf& leaf) const {
        TurnedLeaf result;
        result.leaf = &leaf;
        result.present = (1U << leaf.count) - 1U;
        const Vec3x8 a = result.corner[0] = turn_.point(Vec3x8::load(leaf.corner[0]));
        const Vec3x8 b = result.corner[1] = turn_.point(Vec3x8::load(leaf.corner[1]));
        const Vec3x8 c = result.corner[2] = turn_.point(Vec3x8::load(leaf.corner[2]));
        result.box = {min(min(a, b), c), max(max(a, b), c)};
        result.normal = unitNormals(result.corner);
        result.spilled = Spilled(result.box);
        result.normal.x.store(result.normalLanes[0]);
        result.normal.y.store(result.normalLanes[1]);
        result.normal.z.store(result.normalLanes[2]);
        result.whole = wholeOf(result.spilled, reach_ + slack_);
        return result;
    }

    /// Unit normals; a triangle without area gets a short vector, whose slab widths are short too: still a bound.
    /// (Squares of what is longer than the least length do not underflow.)
    static Vec3x8 unitNormals(const Vec3x8 (&corner)[3]) {
        const Vec3x8 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
        const Float8 length = max(sqrt(dot(normal, normal)), Float8::all(1e-18F));
        return {normal.x / length, normal.y / length, normal.z / length};
    }

    /// Writes the pairs of eight tooth triangles with up to eight tool triangles that no cheap test separates.
    void meet(const TurnedLeaf& tooth, AabbTree::Link toolLink) {
        const AabbTree::Leaf& toolLeaf = toolTree_.leaf(toolLink);
        const ToolShape::Faces& faces = tool_.faces(toolLink);
        std::uint32_t near = facesNear(tooth.whole, faces) & ((1U << toolLeaf.count) - 1U);
        for (; near != 0; near &= near - 1) meetOne(tooth, toolLeaf, faces, std::countr_zero(near));
    }

    /// One bit for each of the tool's triangles whose box and plane both meet the box.
    static std::uint32_t facesNear(const Boxf& box, const ToolShape::Faces& faces) {
        const std::uint32_t boxes = overlaps({Vec3x8::load(faces.low), Vec3x8::load(faces.high)}, box);
        if (boxes == 0) return 0;
        const Vec3x8 low = Vec3x8::all(box.low[0], box.low[1], box.low[2]);
        const Vec3x8 high = Vec3x8::all(box.high[0], box.high[1], box.high[2]);
        const Vec3x8 n = Vec3x8::load(faces.normal);
        const Float8 ax = n.x * low.x, bx = n.x * high.x;
        const Float8 ay = n.y * low.y, by = n.y * high.y;
        const Float8 az = n.z * low.z, bz = n.z * high.z;
        const Float8 nearest = min(ax, bx) + min(ay, by) + min(az, bz);
        const Float8 farthest = max(ax, bx) + max(ay, by) + max(az, bz);
        return boxes & lessEqual(nearest, Float8::load(faces.highOffset)) &
               lessEqual(Float8::load(faces.lowOffset), farthest);
    }

    /// Writes the pairs of eight tooth triangles with the tool's triangle in lane `k`: cheapest tests first.
    void meetOne(const TurnedLeaf& tooth, const AabbTree::Leaf& toolLeaf, const ToolShape::Faces& faces, int k) {
        const Float8 reach = Float8::all(reach_ + slack_);
        const Vec3x8 toolNormal = lane(faces.normal, k);
        const Slabs byTool =
            slabs(toolNormal, tooth.corner, Float8::all(faces.lowOffset[k]), Float8::all(faces.highOffset[k]));
        const Vec3x8 zero = Vec3x8::all(0, 0, 0);
        const Vec3x8 above = max(lane(faces.low, k) - tooth.box.high, zero);
        const Vec3x8 below = max(tooth.box.low - lane(faces.high, k), zero);
        const Vec3x8 gap = above - below;
        const Float8 byBoxes = sqrt(dot(gap, gap));
        std::uint32_t hits = lessEqual(max(byBoxes, byTool.width()), reach) & tooth.present;
        if (hits == 0) return;

        const Float8 a = dot(tooth.normal, lane(toolLeaf.corner[0], k));
        const Float8 b = dot(tooth.normal, lane(toolLeaf.corner[1], k));
        const Float8 c = dot(tooth.normal, lane(toolLeaf.corner[2], k));
        const Slabs byTooth = slabs(tooth.normal, tooth.corner, min(min(a, b), c), max(max(a, b), c));
        hits &= lessEqual(byTooth.width(), reach);
        if (hits == 0) return;
        const Widths widths(byTool, byTooth, byBoxes);
        for (; hits != 0; hits &= hits - 1) {
            const int i = std::countr_zero(hits);
            write({part_, tooth.leaf->triangle[i], toolLeaf.triangle[k], 0, {}}, widths, tooth, faces, i, k);
        }
    }

    static Vec3x8 lane(const float (&p)[3][8], int k) { return Vec3x8::all(p[0][k], p[1][k], p[2][k]); }

    /// Slabs between tooth triangles and tool triangles that span `toolLow` to `toolHigh` along the normal.
    static Slabs slabs(const Vec3x8& normal, const Vec3x8 (&tooth)[3], Float8 toolLow, Float8 toolHigh) {
        const Float8 a = dot(normal, tooth[0]);
        const Float8 b = dot(normal, tooth[1]);
        const Float8 c = dot(normal, tooth[2]);
        return {toolLow - max(max(a, b), c), min(min(a, b), c) - toolHigh};
    }

    /// What was found for eight pairs, spilled to memory so that one can be picked.
    struct Widths {
        float toolFront[8], toolBehind[8], toothFront[8], toothBehind[8], boxes[8];

        Widths(const Slabs& byTool, const Slabs& byTooth, Float8 byBoxes) {
            byTool.toolInFront.store(toolFront), byTool.toolBehind.store(toolBehind);
            byTooth.toolInFront.store(toothFront), byTooth.toolBehind.store(toothBehind);
            byBoxes.store(boxes);
        }
    };

    /// Gap between the boxes of the tooth's triangle `i` and the tool's triangle `k` along one axis, signed.
    static float boxGap(const Spilled& tooth, const ToolShape::Faces& faces, int axis, int i, int k) {
        return std::max(faces.low[axis][k] - tooth.high[axis][i], 0.0F) -
               std::max(tooth.low[axis][i] - faces.high[axis][k], 0.0F);
    }

    /// Writes the pair with the widest of its slabs.
    void write(NearPair pair, const Widths& widths, const TurnedLeaf& tooth, const ToolShape::Faces& faces, int i,
               int k) {
        if (hidden_ != nullptr && isHidden(*hidden_, pair.tooth)) return;
        if (count_ == out_.size()) {
            complete_ = false;
            return;
        }
        const float byTool = std::max(widths.toolFront[i], widths.toolBehind[i]);
        const float byTooth = std::max(widths.toothFront[i], widths.toothBehind[i]);
        const float widest = std::max({byTool, byTooth, widths.boxes[i]});
        for (int axis = 0; axis < 3; ++axis) {
            if (widest == byTool) {
                pair.normal[axis] =
                    std::copysign(1.0F, widths.toolFront[i] - widths.toolBehind[i]) * faces.normal[axis][k];
            } else if (widest == byTooth) {
                pair.normal[axis] =
                    std::copysign(1.0F, widths.toothFront[i] - widths.toothBehind[i]) * tooth.normalLanes[axis][i];
            } else {
                pair.normal[axis] = boxGap(tooth.spilled, faces, axis, i, k) / widest;
            }
        }
        pair.distanceAtLeast = std::max(widest - slack_, 0.0F);
        out_[count_++] = pair;
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
    std::array<Suspects, 1024> stack_;  // a tool of 3,000 triangles needs some 200
    std::size_t used_ = 0;
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
