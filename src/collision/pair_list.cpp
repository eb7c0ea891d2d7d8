// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/pair_list.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "collision/gjk.h"

// Pair list with a skin: L. Verlet, "Computer Experiments on Classical Fluids", Phys. Rev. 159, 1967. Differs from the
// paper: what is listed carries a separating direction with its gap, so a move along the surface, or away from it, does
// not use the gap up; a turn counts by its lever arm; and there are two levels, the second filled in where it is asked.
// Within the list a shorter one serves a few steps, as in S. Pall et al., "Heterogeneous parallelization and
// acceleration of molecular dynamics simulations in GROMACS", J. Chem. Phys. 153, 2020 (dual pair list).

namespace tactooth {
namespace {

constexpr std::size_t kPlentyOfClusters = 1024;  // a longer list costs more to make and walk than listing twice
constexpr double kLeastReach = 0.001;            // of the tool's radius: 10 um for a bur of 20 mm with its shank
constexpr double kGreatestReach = 1.0;           // of the tool's radius
constexpr std::uint32_t kClosed = ~0U;

// A look around serves a few steps like the one at hand, and others that stray from its way by some share of it, by
// some micrometres and by 20 arc seconds.
constexpr float kStepsAround = 4;
constexpr float kStrayAround = 0.25F;
constexpr float kLeastAroundShift = 0.002F;  // mm
constexpr float kLeastAroundTurn = 1e-4F;    // chord
constexpr float kAroundSpare = 1e-5F;        // mm: what steps must leave grows with the distance from the origin

/// The first in lanes 0-3, the second in lanes 4-7.
Vec3x8 sideBySide(const Vec3f& a, const Vec3f& b) {
    float lanes[3][8];
    for (int axis = 0; axis < 3; ++axis) {
        std::fill_n(lanes[axis], 4, a[axis]);
        std::fill_n(lanes[axis] + 4, 4, b[axis]);
    }
    return Vec3x8::load(lanes);
}

/// The least of three points' dot products with eight directions.
Float8 lowestOf(const std::array<Vec3f, 3>& points, const Vec3x8& directions) {
    return min(min(dot(directions, everywhere(points[0])), dot(directions, everywhere(points[1]))),
               dot(directions, everywhere(points[2])));
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

/// Eight directions, each with the slab found along it: the greatest point of the tooth and the width.
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

/// From the box of each tooth triangle to the tool triangle's; zero where they meet.
Vec3x8 betweenBoxes(const float (&tooth)[3][3][8], const std::array<Vec3f, 3>& tool) {
    const Vec3x8 a = Vec3x8::load(tooth[0]), b = Vec3x8::load(tooth[1]), c = Vec3x8::load(tooth[2]);
    const Vec3f low = tool[0].cwiseMin(tool[1]).cwiseMin(tool[2]);
    const Vec3f high = tool[0].cwiseMax(tool[1]).cwiseMax(tool[2]);
    const Vec3x8 zero = Vec3x8::all(0, 0, 0);
    const Vec3x8 between =
        max(everywhere(low) - max(max(a, b), c), zero) - max(min(min(a, b), c) - everywhere(high), zero);
    const Float8 length = max(sqrt(dot(between, between)), Float8::all(1e-18F));
    return {between.x / length, between.y / length, between.z / length};
}

/// One bit for each of eight clusters whose slab leaves what it must with the tool moved by `way`.
/// `used`: what it must leave besides.
std::uint32_t slabsHold(const EightClusters& eight, const Excursion::Way& way, Float8 used) {
    const Vec3x8 n = Vec3x8::load(eight.normal);
    const Vec3x8 turned = {dot(n, everywhere(way.turn.col(0))), dot(n, everywhere(way.turn.col(1))),
                           dot(n, everywhere(way.turn.col(2)))};
    const Float8 left =
        Float8::load(eight.gap) + dot(n, everywhere(way.shift)) + dot(turned, Vec3x8::load(eight.centre));
    return lessEqual(Float8::load(eight.radius) * Float8::all(way.perLength) + Float8::all(way.spare), left - used);
}
std::uint32_t slabsHold(const EightClusters& eight, const Excursion::Way& way) {
    return slabsHold(eight, way, Float8::all(0));
}

/// The turn between two ways as a chord: two rotations differ by that in no direction more.
float chordBetween(const Excursion::Way& a, const Excursion::Way& b) {
    return (a.turn - b.turn).norm() * std::numbers::sqrt2_v<float> / 2;
}

}  // namespace

PairList::PairList(const ToolShape& tool, std::size_t capacity) : tool_(&tool), near_(0) {
    reserve(capacity);
    forget();
}

void PairList::forget() {
    clear();
    cap_ = kGreatestReach * tool_->radius();
}

double PairList::leastAround() const { return kLeastReach * tool_->radius(); }

bool PairList::isLong() const { return 2 * near_.count > kPlentyOfClusters; }

double PairList::leastTurn() { return kLeastReach; }

Work PairList::make(const Surface& surface, const Pose& toolInTooth, const Skin& wanted) {
    skin_ = {wanted.along, std::max(wanted.around, leastAround()), std::max(wanted.turn, leastTurn())};
    shortenTo(cap_);
    cap_ = std::min(2 * cap_, kGreatestReach * tool_->radius());
    Work work = 0;
    while (true) {
        const bool shortest = skin_.along.isZero() && skin_.around <= leastAround() && skin_.turn <= leastTurn();
        list(surface, toolInTooth, shortest ? near_.capacity() : kPlentyOfClusters);
        work += cost::kList + cost::kLeafMet * static_cast<Work>(near_.leavesMet) +
                cost::kListed * static_cast<Work>(near_.count);
        if (near_.complete || shortest) break;
        cap_ = (skin_.along.norm() + skin_.around) / 2;
        shortenTo(cap_);
    }
    if (4 * near_.count > kPlentyOfClusters)
        cap_ = std::min(cap_, skin_.along.norm() + skin_.around);  // it may stay so
    if (!near_.complete) skin_ = {};
    return work;
}

/// Makes the skin as short as that, or the least.
void PairList::shortenTo(double length) {
    const double now = skin_.along.norm() + skin_.around;
    if (now <= length) return;
    skin_.along *= length / now;
    skin_.around = std::max(leastAround(), skin_.around * length / now);
    skin_.turn = std::max(leastTurn(), skin_.turn * length / now);
    if (skin_.along.norm() < leastAround()) skin_.along.setZero();
}

void PairList::makeAll(const Surface& surface, const Pose& toolInTooth, const Skin& skin) {
    skin_ = skin;
    list(surface, toolInTooth, near_.capacity());
    while (!near_.complete) {
        reserve(std::max(4 * near_.capacity(), kUsualCapacity));
        list(surface, toolInTooth, near_.capacity());
    }
}

bool PairList::makeUpTo(const Surface& surface, const Pose& toolInTooth, std::size_t limit) {
    skin_ = {};
    if (limit > near_.capacity()) reserve(limit);
    list(surface, toolInTooth, limit);
    return near_.complete;
}

void PairList::reserve(std::size_t capacity) {
    near_ = NearClusters(capacity);
    around_.eights.resize(near_.eights.size());
    pairs_.resize(capacity / 4);
    opened_.resize(capacity);
}

void PairList::list(const Surface& surface, const Pose& toolInTooth, std::size_t limit) {
    at_ = toolInTooth;
    rotation_ = at_.rotation.toRotationMatrix();
    findNearClusters(surface, *tool_, at_, skin_, limit, near_);
    std::fill_n(opened_.begin(), near_.count, kClosed);
    openedCount_ = 0;
    around_.stray = around_.turn = -1;
    made_ = true;
}

Excursion PairList::excursion(const Pose& start, const Pose& end, double margin, std::span<const Vec3> known) const {
    const double rounding =
        kFewRoundings * (skin_.along.norm() + skin_.around + skin_.turn * (tool_->centre().norm() + tool_->radius()));
    const auto way = [&](const Pose& pose, double spare) {
        const Mat3 turn = rotation_.transpose() * pose.rotation.toRotationMatrix() - Mat3::Identity();
        const Vec3 shift = rotation_.transpose() * (pose.position - at_.position);
        const double perLength = chordBetween(pose.rotation, at_.rotation) * (1 + kFewRoundings);
        return Excursion::Way{turn.cast<float>(), shift.cast<float>(), static_cast<float>(perLength),
                              static_cast<float>(spare + rounding)};
    };
    Excursion result;
    result.start = way(start, 0);
    result.end = way(end, margin);
    result.knownCount = static_cast<int>(known.size());
    for (int i = 0; i < 3; ++i) result.column[i] = sideBySide(result.start.turn.col(i), result.end.turn.col(i));
    result.column[0].x = result.column[0].x + Float8::all(1);
    result.column[1].y = result.column[1].y + Float8::all(1);
    result.column[2].z = result.column[2].z + Float8::all(1);
    result.shift = sideBySide(result.start.shift, result.end.shift);
    for (std::size_t i = 0; i < known.size(); ++i) result.known[i] = (rotation_.transpose() * known[i]).cast<float>();
    return result;
}

bool PairList::Surroundings::cover(const Excursion::Way& way) const {
    const Vec3f shift = way.shift - middle.shift;
    const float squared = along.squaredNorm();
    const float share = squared > 0 ? std::clamp(shift.dot(along) / squared, 0.0F, 1.0F) : 0.0F;
    return (shift - share * along).norm() <= stray && chordBetween(way, middle) <= turn && way.spare <= middle.spare;
}

std::span<const std::uint32_t> PairList::within(const Excursion& excursion) {
    if (!around_.cover(excursion.start) || !around_.cover(excursion.end)) lookAround(excursion);
    return std::span(around_.eights).first(around_.count);
}

/// What is left of a slab at the middle is used up by no step that goes less far from there along its normal.
void PairList::lookAround(const Excursion& excursion) {
    around_.middle = excursion.start;
    around_.middle.spare = std::max(excursion.start.spare, excursion.end.spare) + kAroundSpare;
    const Vec3f step = excursion.end.shift - excursion.start.shift;
    around_.along = kStepsAround * step;
    around_.stray = kStrayAround * step.norm() + kLeastAroundShift;
    around_.turn = kStepsAround * chordBetween(excursion.start, excursion.end) + kLeastAroundTurn;
    around_.count = 0;
    const Float8 stray = Float8::all(around_.stray), turn = Float8::all(around_.turn), zero = Float8::all(0);
    const Vec3x8 back = everywhere(-around_.along);
    for (std::size_t i = 0; 8 * i < near_.count; ++i) {
        const EightClusters& eight = near_.eights[i];
        const Vec3x8 centre = Vec3x8::load(eight.centre);
        const Float8 closing = stray + max(dot(Vec3x8::load(eight.normal), back), zero);
        const Float8 used = closing + turn * (sqrt(dot(centre, centre)) + Float8::load(eight.radius));
        const std::size_t rest = near_.count - 8 * i;
        const std::uint32_t present = rest >= 8 ? 0xFFU : (1U << rest) - 1U;
        if ((~slabsHold(eight, around_.middle, used) & present) != 0)
            around_.eights[around_.count++] = static_cast<std::uint32_t>(8 * i);
    }
}

std::uint32_t PairList::clustersInDoubt(std::size_t first, const Excursion& excursion) const {
    const std::size_t rest = near_.count - first;
    const EightClusters& eight = near_.eights[first / 8];
    return ~(slabsHold(eight, excursion.start) & slabsHold(eight, excursion.end)) &
           (rest >= 8 ? 0xFFU : (1U << rest) - 1U);
}

/// The slabs of a cluster's pairs; null where there is no room for more of them.
PairList::EightPairs* PairList::open(std::size_t cluster) {
    std::uint32_t& place = opened_[cluster];
    if (place != kClosed) return &pairs_[place];
    if (openedCount_ == pairs_.size()) return nullptr;
    place = static_cast<std::uint32_t>(openedCount_++);
    const EightClusters& eight = eightOf(cluster);
    fill(pairs_[place], near_.leaves[eight.leaf[cluster % 8]], eight.tool[cluster % 8]);
    return &pairs_[place];
}

/// Finds for each pair the widest slab along the normals of the two triangles and from box to box.
void PairList::fill(EightPairs& pairs, const NearLeaf& leaf, std::uint32_t tool) const {
    const std::array<Vec3f, 3>& corners = tool_->floatCorners(tool);
    const Vec3x8 toolNormal = everywhere(tool_->normal(tool));
    const Vec3x8 toothNormals = Vec3x8::load(leaf.normal);
    Slabs best(toolNormal, leaf.corner, corners);
    best.takeWider(Slabs(opposite(toolNormal), leaf.corner, corners));
    best.takeWider(Slabs(toothNormals, leaf.corner, corners));
    best.takeWider(Slabs(opposite(toothNormals), leaf.corner, corners));
    best.takeWider(Slabs(betweenBoxes(leaf.corner, corners), leaf.corner, corners));
    best.normal.store(pairs.normal);
    best.high.store(pairs.high);
    pairs.stubborn = 0;
}

/// A triangle of the tool at the start and the end of a step, and what it must keep from the tooth.
struct PairList::Swept {
    float corner[3][8];  // axis by axis: lanes 0-2 at the start, 4-6 at the end
    Float8 startSpare, endSpare;

    /// How far up a tooth may reach along each of eight directions.
    [[nodiscard]] Float8 room(const Vec3x8& directions) const {
        const auto along = [&](int lane) {
            return dot(directions, Vec3x8::all(corner[0][lane], corner[1][lane], corner[2][lane]));
        };
        return min(min(min(along(0), along(1)), along(2)) - startSpare,
                   min(min(along(4), along(5)), along(6)) - endSpare);
    }
};

PairList::Swept PairList::sweep(std::uint32_t tool, const Excursion& excursion) const {
    const auto slack = static_cast<float>(2 * near_.slack);
    Swept swept{{}, Float8::all(excursion.start.spare + slack), Float8::all(excursion.end.spare + slack)};
    const Vec3x8 p = Vec3x8::load(tool_->cornerLanes(tool).axis);
    const auto times = [](const Vec3x8& column, Float8 by) {
        return Vec3x8{column.x * by, column.y * by, column.z * by};
    };
    const Vec3x8 turned =
        times(excursion.column[0], p.x) + times(excursion.column[1], p.y) + times(excursion.column[2], p.z);
    (turned + excursion.shift).store(swept.corner);
    return swept;
}

/// Takes these directions for the pairs in doubt that they part the whole way. Returns the pairs left in doubt.
std::uint32_t PairList::part(const Vec3x8& directions, const NearLeaf& leaf, const Swept& tool, std::uint32_t doubt,
                             EightPairs& pairs) {
    const Float8 high = highestOf(leaf.corner, directions);
    const std::uint32_t parted = lessEqual(high, tool.room(directions)) & doubt;
    if (parted == 0) return doubt;
    EightPairs found;
    directions.store(found.normal);
    high.store(found.high);
    for (std::uint32_t rest = parted; rest != 0; rest &= rest - 1) {
        const int lane = std::countr_zero(rest);
        for (int axis = 0; axis < 3; ++axis) pairs.normal[axis][lane] = found.normal[axis][lane];
        pairs.high[lane] = found.high[lane];
    }
    return doubt & ~parted;
}

/// Takes a plane that holds the tool for the slab of a whole cluster, if it parts that the whole way: what touches
/// separates its neighbourhood too.
bool PairList::partCluster(std::size_t cluster, const Excursion& excursion, const Swept& swept) {
    EightClusters& eight = near_.eights[cluster / 8];
    const std::size_t lane = cluster % 8;
    const NearLeaf& leaf = near_.leaves[eight.leaf[lane]];
    for (int i = 0; i < excursion.knownCount; ++i) {
        const Vec3f& known = excursion.known[i];
        const Vec3x8 directions = everywhere(known);
        const Float8 high = highestOf(leaf.corner, directions);
        if (lessEqual(high, swept.room(directions)) != 0xFF) continue;
        for (int axis = 0; axis < 3; ++axis) eight.normal[axis][lane] = known[axis];
        const std::array<Vec3f, 3>& corners = tool_->floatCorners(eight.tool[lane]);
        eight.gap[lane] = lowestAlong(corners, known) - highest(high) - static_cast<float>(near_.slack);
        return true;
    }
    return false;
}

std::uint32_t PairList::pairsInDoubt(std::size_t cluster, const Excursion& excursion) {
    const EightClusters& eight = eightOf(cluster);
    const NearLeaf& leaf = near_.leaves[eight.leaf[cluster % 8]];
    const std::uint32_t tool = eight.tool[cluster % 8];
    const Swept swept = sweep(tool, excursion);
    const auto ownDoubt = [&](const EightPairs& pairs) {
        const Float8 room = swept.room(Vec3x8::load(pairs.normal));
        return leaf.present & ~lessEqual(Float8::load(pairs.high), room);
    };
    // What the pairs' own slabs hold is told sooner by these than by the planes that hold the tool.
    if (opened_[cluster] != kClosed && ownDoubt(pairs_[opened_[cluster]]) == 0) return 0;
    if (partCluster(cluster, excursion, swept)) return 0;
    EightPairs* pairs = open(cluster);
    if (pairs == nullptr) return leaf.present;
    std::uint32_t doubt = ownDoubt(*pairs);
    for (int i = 0; i < excursion.knownCount && doubt != 0; ++i)
        doubt = part(everywhere(excursion.known[i]), leaf, swept, doubt, *pairs);
    if ((doubt & ~pairs->stubborn) == 0) return doubt;
    const Vec3x8 toothNormals = Vec3x8::load(leaf.normal);
    doubt = part(toothNormals, leaf, swept, doubt, *pairs);
    if (doubt != 0) doubt = part(opposite(toothNormals), leaf, swept, doubt, *pairs);
    const Vec3x8 toolNormal = everywhere(tool_->normal(tool));
    if (doubt != 0) doubt = part(opposite(toolNormal), leaf, swept, doubt, *pairs);
    if (doubt != 0) doubt = part(toolNormal, leaf, swept, doubt, *pairs);
    pairs->stubborn = doubt;
    return doubt;
}

void PairList::partAhead(const Surface& surface, const Pose& start, const Pose& end, double margin) {
    const Excursion way = excursion(start, end, margin, {});
    for (std::size_t first = 0; first < near_.count; first += 8) {
        for (std::uint32_t near = clustersInDoubt(first, way); near != 0; near &= near - 1) {
            const std::size_t cluster = first + static_cast<std::size_t>(std::countr_zero(near));
            for (std::uint32_t doubt = pairsInDoubt(cluster, way); doubt != 0; doubt &= doubt - 1) {
                partPairAhead(surface, placeOf(cluster, std::countr_zero(doubt)), start, end);
            }
        }
    }
}

void PairList::partPairAhead(const Surface& surface, std::size_t place, const Pose& start, const Pose& end) {
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

NearPair PairList::operator[](std::size_t place) const {
    const EightClusters& eight = eightOf(place / 8);
    const std::size_t lane = place / 8 % 8;
    const NearLeaf& leaf = near_.leaves[eight.leaf[lane]];
    return {leaf.part, leaf.triangle[place % 8], eight.tool[lane]};
}

Vec3 PairList::direction(std::size_t place) const {
    const std::uint32_t opened = opened_[place / 8];
    if (opened == kClosed) return Vec3::Zero();
    const auto& n = pairs_[opened].normal;
    return rotation_ * Vec3(n[0][place % 8], n[1][place % 8], n[2][place % 8]);
}

void PairList::certify(std::size_t place, const Vec3& normal, double offset) {
    const std::uint32_t opened = opened_[place / 8];
    if (opened == kClosed) return;
    const Vec3 inTool = rotation_.transpose() * normal;
    for (int axis = 0; axis < 3; ++axis) pairs_[opened].normal[axis][place % 8] = static_cast<float>(inTool[axis]);
    pairs_[opened].high[place % 8] = static_cast<float>(offset - normal.dot(at_.position));
    pairs_[opened].stubborn &= ~(1U << (place % 8));
}

}  // namespace tactooth
