// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>

#include "collision/narrow/gjk.h"
#include "collision/neighbours/neighbour_list.h"
#include "geometry/util/pose.h"

// The lowest level of the list: the pairs of a cluster. A cluster is opened when a step makes it uncertain. Separating
// axes: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: A Hierarchical Structure for Rapid Interference Detection",
// SIGGRAPH 1996, section 5. Differs from the paper: the axes are those of two triangles and their boxes, eight pairs at
// a time, and the best axis is kept for later steps.

namespace tactooth {
namespace {

/// The least of three points' dot products with eight directions.
Float8 lowestOf(const std::array<Vec3f, 3>& points, const Vec3x8& directions) {
    return min(min(dot(directions, broadcast(points[0])), dot(directions, broadcast(points[1]))),
               dot(directions, broadcast(points[2])));
}

/// The greatest dot product of eight triangles' corners with eight directions.
Float8 highestOf(const float (&corner)[3][3][8], const Vec3x8& directions) {
    return max(max(dot(directions, Vec3x8::load(corner[0])), dot(directions, Vec3x8::load(corner[1]))),
               dot(directions, Vec3x8::load(corner[2])));
}

float lowestAlong(const std::array<Vec3f, 3>& points, const Vec3f& direction) {
    return std::min({direction.dot(points[0]), direction.dot(points[1]), direction.dot(points[2])});
}

Vec3x8 opposite(const Vec3x8& v) { return Vec3x8::all(0, 0, 0) - v; }

/// Eight directions, each with a slab: where the tooth ends along it, and the width.
struct Slabs {
    Vec3x8 normal;
    Float8 high;
    Float8 width;

    Slabs(const Vec3x8& along, const float (&tooth)[3][3][8], const std::array<Vec3f, 3>& tool)
        : normal(along), high(highestOf(tooth, along)), width(lowestOf(tool, along) - high) {}

    void takeWider(const Slabs& other) {
        const auto wider = [&](Float8 mine, Float8 its) { return whereLess(width, other.width, its, mine); };
        normal = {wider(normal.x, other.normal.x), wider(normal.y, other.normal.y), wider(normal.z, other.normal.z)};
        high = wider(high, other.high);
        width = wider(width, other.width);
    }
};

/// The directions from the box of each tooth triangle to the box of the tool triangle; zero if they overlap.
Vec3x8 betweenBoxes(const float (&tooth)[3][3][8], const std::array<Vec3f, 3>& tool) {
    const Vec3x8 a = Vec3x8::load(tooth[0]), b = Vec3x8::load(tooth[1]), c = Vec3x8::load(tooth[2]);
    const Vec3f low = tool[0].cwiseMin(tool[1]).cwiseMin(tool[2]);
    const Vec3f high = tool[0].cwiseMax(tool[1]).cwiseMax(tool[2]);
    const Vec3x8 zero = Vec3x8::all(0, 0, 0);
    const Vec3x8 between =
        max(broadcast(low) - max(max(a, b), c), zero) - max(min(min(a, b), c) - broadcast(high), zero);
    const Float8 length = max(sqrt(dot(between, between)), Float8::all(1e-18F));
    return {between.x / length, between.y / length, between.z / length};
}

}  // namespace

/// The slabs of a cluster's pairs; null if there is no room for more.
NeighbourList::PairPacket* NeighbourList::open(std::size_t cluster) {
    TACTOOTH_ASSERT(cluster < near_.count);
    std::uint32_t& place = opened_[cluster];
    if (place != kClosed) return &pairs_[place];
    if (openedCount_ == pairs_.size()) return nullptr;
    place = static_cast<std::uint32_t>(openedCount_++);
    const ClusterPacket& packet = packetOf(cluster);
    fill(pairs_[place], near_.leaves[packet.leaf[cluster % 8]], packet.tool[cluster % 8]);
    return &pairs_[place];
}

/// Finds for each pair the widest slab along the normals of the two triangles, or from box to box.
void NeighbourList::fill(PairPacket& pairs, const NearLeaf& leaf, std::uint32_t tool) const {
    const std::array<Vec3f, 3>& corners = tool_->floatCorners(tool);
    const Vec3x8 toolNormal = broadcast(tool_->normal(tool));
    const Vec3x8 toothNormals = Vec3x8::load(leaf.normal);
    Slabs best(toolNormal, leaf.corner, corners);
    best.takeWider(Slabs(opposite(toolNormal), leaf.corner, corners));
    best.takeWider(Slabs(toothNormals, leaf.corner, corners));
    best.takeWider(Slabs(opposite(toothNormals), leaf.corner, corners));
    best.takeWider(Slabs(betweenBoxes(leaf.corner, corners), leaf.corner, corners));
    best.normal.store(pairs.normal);
    best.high.store(pairs.high);
    pairs.unseparable = 0;
}

/// A triangle of the tool at the start and the end of a step, and the distance that it must keep from the tooth.
struct NeighbourList::Swept {
    float corner[3][8];  // axis by axis: lanes 0-2 at the start, 4-6 at the end
    Float8 startSpare, endSpare;

    /// How far the tooth may reach along each of eight directions without coming too near, mm.
    [[nodiscard]] Float8 toothLimit(const Vec3x8& directions) const {
        const auto along = [&](int lane) {
            return dot(directions, Vec3x8::all(corner[0][lane], corner[1][lane], corner[2][lane]));
        };
        return min(min(min(along(0), along(1)), along(2)) - startSpare,
                   min(min(along(4), along(5)), along(6)) - endSpare);
    }
};

NeighbourList::Swept NeighbourList::sweep(std::uint32_t tool, const ToolMotion& motion) const {
    const auto slack = static_cast<float>(2 * near_.slack);
    Swept swept{{}, Float8::all(motion.start.spare + slack), Float8::all(motion.end.spare + slack)};
    const Vec3x8 p = Vec3x8::load(tool_->cornerLanes(tool).axis);
    const auto times = [](const Vec3x8& column, Float8 by) {
        return Vec3x8{column.x * by, column.y * by, column.z * by};
    };
    const Vec3x8 turned = times(motion.column[0], p.x) + times(motion.column[1], p.y) + times(motion.column[2], p.z);
    (turned + motion.shift).store(swept.corner);
    return swept;
}

/// Uses these directions for the uncertain pairs that they separate during the whole step. Returns the pairs that stay
/// uncertain.
std::uint32_t NeighbourList::separatePairs(const Vec3x8& directions, const NearLeaf& leaf, const Swept& tool,
                                           std::uint32_t uncertain, PairPacket& pairs) {
    const Float8 high = highestOf(leaf.corner, directions);
    const std::uint32_t separated = lessEqual(high, tool.toothLimit(directions)) & uncertain;
    if (separated == 0) return uncertain;
    PairPacket found;
    directions.store(found.normal);
    high.store(found.high);
    for (std::uint32_t rest = separated; rest != 0; rest &= rest - 1) {
        const int lane = std::countr_zero(rest);
        for (int axis = 0; axis < 3; ++axis) pairs.normal[axis][lane] = found.normal[axis][lane];
        pairs.high[lane] = found.high[lane];
    }
    return uncertain & ~separated;
}

/// Uses a known direction for the slab of a whole cluster, if it separates the cluster during the whole step. (A plane
/// that separates a contact often separates its neighbourhood.)
bool NeighbourList::separateCluster(std::size_t cluster, const ToolMotion& motion, const Swept& swept) {
    ClusterPacket& packet = near_.packets[cluster / 8];
    const std::size_t lane = cluster % 8;
    const NearLeaf& leaf = near_.leaves[packet.leaf[lane]];
    for (int i = 0; i < motion.knownCount; ++i) {
        const Vec3f& known = motion.known[i];
        const Vec3x8 directions = broadcast(known);
        const Float8 high = highestOf(leaf.corner, directions);
        if (lessEqual(high, swept.toothLimit(directions)) != 0xFF) continue;
        for (int axis = 0; axis < 3; ++axis) packet.normal[axis][lane] = known[axis];
        const std::array<Vec3f, 3>& corners = tool_->floatCorners(packet.tool[lane]);
        packet.gap[lane] = lowestAlong(corners, known) - highest(high) - static_cast<float>(near_.slack);
        return true;
    }
    return false;
}

std::uint32_t NeighbourList::uncertainPairs(std::size_t cluster, const ToolMotion& motion) {
    const ClusterPacket& packet = packetOf(cluster);
    const NearLeaf& leaf = near_.leaves[packet.leaf[cluster % 8]];
    const std::uint32_t tool = packet.tool[cluster % 8];
    const Swept swept = sweep(tool, motion);
    const auto ownUncertain = [&](const PairPacket& pairs) {
        const Float8 limit = swept.toothLimit(Vec3x8::load(pairs.normal));
        return leaf.present & ~lessEqual(Float8::load(pairs.high), limit);
    };
    // The pairs' own slabs are a quicker test than the known directions.
    if (opened_[cluster] != kClosed && ownUncertain(pairs_[opened_[cluster]]) == 0) return 0;
    if (separateCluster(cluster, motion, swept)) return 0;
    PairPacket* pairs = open(cluster);
    if (pairs == nullptr) return leaf.present;
    std::uint32_t uncertain = ownUncertain(*pairs);
    for (int i = 0; i < motion.knownCount && uncertain != 0; ++i)
        uncertain = separatePairs(broadcast(motion.known[i]), leaf, swept, uncertain, *pairs);
    for (std::size_t i = 0; i < std::min(recentCount_, recentDirections_.size()) && uncertain != 0; ++i)
        uncertain = separatePairs(broadcast(recentDirections_[i]), leaf, swept, uncertain, *pairs);
    if ((uncertain & ~pairs->unseparable) == 0) return uncertain;
    const Vec3x8 toothNormals = Vec3x8::load(leaf.normal);
    uncertain = separatePairs(toothNormals, leaf, swept, uncertain, *pairs);
    if (uncertain != 0) uncertain = separatePairs(opposite(toothNormals), leaf, swept, uncertain, *pairs);
    const Vec3x8 toolNormal = broadcast(tool_->normal(tool));
    if (uncertain != 0) uncertain = separatePairs(opposite(toolNormal), leaf, swept, uncertain, *pairs);
    if (uncertain != 0) uncertain = separatePairs(toolNormal, leaf, swept, uncertain, *pairs);
    pairs->unseparable = uncertain;
    return uncertain;
}

std::uint32_t NeighbourList::separateBy(const Vec3& direction, std::size_t cluster, std::uint32_t uncertain,
                                        const ToolMotion& motion) {
    TACTOOTH_ASSERT(cluster < near_.count);
    TACTOOTH_ASSERT(uncertain <= 0xFF);
    TACTOOTH_ASSERT(isUnit(direction));
    if (opened_[cluster] == kClosed) return uncertain;
    const ClusterPacket& packet = packetOf(cluster);
    const Swept swept = sweep(packet.tool[cluster % 8], motion);
    const Vec3x8 directions = broadcast(Vec3f((rotation_.transpose() * direction).cast<float>()));
    return separatePairs(directions, near_.leaves[packet.leaf[cluster % 8]], swept, uncertain,
                         pairs_[opened_[cluster]]);
}

void NeighbourList::separateAhead(const Surface& surface, const Pose& start, const Pose& end, double margin) {
    const ToolMotion stepMotion = motion(start, end, margin, {});
    openUncertain(stepMotion);
    for (std::size_t first = 0; first < near_.count; first += 8) {
        for (std::uint32_t near = uncertainClusters(first, stepMotion); near != 0; near &= near - 1) {
            const std::size_t cluster = first + static_cast<std::size_t>(std::countr_zero(near));
            for (std::uint32_t uncertain = uncertainPairs(cluster, stepMotion); uncertain != 0;
                 uncertain &= uncertain - 1) {
                separatePairAhead(surface, placeOf(cluster, std::countr_zero(uncertain)), start, end);
            }
        }
    }
}

void NeighbourList::separatePairAhead(const Surface& surface, std::size_t place, const Pose& start, const Pose& end) {
    const NearPair pair = (*this)[place];
    const Triangle3 tooth = cornersOf(partOf(surface, pair.part).mesh(), pair.tooth);
    std::array<Vec3, 6> swept;
    for (int i = 0; i < 3; ++i) {
        swept[i] = start * tool_->corners(pair.tool)[i];
        swept[i + 3] = end * tool_->corners(pair.tool)[i];
    }
    const Vec3 known = direction(place);
    const GjkResult result = distanceBetween(tooth, swept, known.isZero() ? Vec3(swept[0] - tooth[0]) : known);
    if (result.separated) certify(place, result.normal, highestAlong(tooth, result.normal));
}

NearPair NeighbourList::operator[](std::size_t place) const {
    const ClusterPacket& packet = packetOf(place / 8);
    const std::size_t lane = place / 8 % 8;
    const NearLeaf& leaf = near_.leaves[packet.leaf[lane]];
    TACTOOTH_ASSERT(((leaf.present >> (place % 8)) & 1U) != 0);
    return {leaf.part, leaf.triangle[place % 8], packet.tool[lane]};
}

Vec3 NeighbourList::direction(std::size_t place) const {
    TACTOOTH_ASSERT(place / 8 < near_.count);
    const std::uint32_t opened = opened_[place / 8];
    if (opened == kClosed) return Vec3::Zero();
    const auto& n = pairs_[opened].normal;
    return rotation_ * Vec3(n[0][place % 8], n[1][place % 8], n[2][place % 8]);
}

void NeighbourList::certify(std::size_t place, const Vec3& normal, double offset) {
    TACTOOTH_ASSERT(place / 8 < near_.count);
    TACTOOTH_ASSERT(isUnit(normal) && std::isfinite(offset));
    const std::uint32_t opened = opened_[place / 8];
    if (opened == kClosed) return;
    const Vec3 inTool = rotation_.transpose() * normal;
    recentDirections_[recentCount_++ % recentDirections_.size()] = inTool.cast<float>();
    for (int axis = 0; axis < 3; ++axis) pairs_[opened].normal[axis][place % 8] = static_cast<float>(inTool[axis]);
    pairs_[opened].high[place % 8] = static_cast<float>(offset - normal.dot(at_.position));
    pairs_[opened].unseparable &= ~(1U << (place % 8));
}

}  // namespace tactooth
