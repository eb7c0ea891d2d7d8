// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/neighbours/pair_list.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "collision/narrow/gjk.h"

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
    near_.count = 0;
    cap_ = kGreatestReach * tool_->radius();
}

double PairList::leastAround() const { return kLeastReach * tool_->radius(); }

bool PairList::isLong() const { return 2 * near_.count > kPlentyOfClusters; }

double PairList::leastTurn() { return kLeastReach; }

void PairList::make(const Surface& surface, const Pose& toolInTooth, const Skin& wanted) {
    if (4 * near_.count > kPlentyOfClusters) cap_ = std::min(cap_, skin_.length());
    skin_ = {wanted.along, std::max(wanted.around, leastAround()), std::max(wanted.turn, leastTurn())};
    shortenTo(cap_);
    cap_ = std::min(2 * cap_, kGreatestReach * tool_->radius());
    work_ += cost::kList;
    list(surface, toolInTooth, isShortest() ? near_.capacity() : kPlentyOfClusters);
}

bool PairList::isShortest() const {
    return skin_.along.isZero() && skin_.around <= leastAround() && skin_.turn <= leastTurn();
}

bool PairList::shorten() {
    clear();
    cap_ = skin_.length() / 2;
    return !isShortest();
}

/// Makes the skin as short as that, or the least.
void PairList::shortenTo(double length) {
    const double now = skin_.length();
    if (now <= length) return;
    skin_.along *= length / now;
    skin_.around = std::max(leastAround(), skin_.around * length / now);
    skin_.turn = std::max(leastTurn(), skin_.turn * length / now);
    if (skin_.along.norm() < leastAround()) skin_.along.setZero();
}

void PairList::makeAll(const Surface& surface, const Pose& toolInTooth, const Skin& skin) {
    skin_ = skin;
    list(surface, toolInTooth, near_.capacity());
    openAll();
    while (!near_.complete) {
        reserve(std::max(4 * near_.capacity(), kUsualCapacity));
        list(surface, toolInTooth, near_.capacity());
        openAll();
    }
    work_ = 0;  // nobody waits for it
}

void PairList::makeWithRoom(const Surface& surface, const Pose& toolInTooth, const Skin& wanted, double least,
                            double most) {
    skin_ = wanted;
    shortenTo(std::max(least, most));
    list(surface, toolInTooth, near_.capacity());
    openAll();
    for (double length = skin_.length(); !near_.complete && length > least;) {
        length = std::max(length / 2, least);
        shortenTo(length);
        list(surface, toolInTooth, near_.capacity());
        openAll();
    }
    if (!near_.complete) makeAll(surface, toolInTooth, skin_);
    work_ = 0;
}

bool PairList::makeUpTo(const Surface& surface, const Pose& toolInTooth, std::size_t limit) {
    skin_ = {};
    if (limit > near_.capacity()) reserve(limit);
    list(surface, toolInTooth, limit);
    openAll();
    work_ = 0;
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
    limit_ = limit;
    openedCount_ = metCount_ = 0;
    around_.stray = around_.turn = -1;
    made_ = true;
    walk_.begin(surface, *tool_, at_, skin_, near_);
}

void PairList::openNode(const NearNode& node, int child) {
    const std::size_t before = near_.count;
    walk_.open(node, child, limit_, near_);
    std::fill(opened_.begin() + static_cast<std::ptrdiff_t>(before),
              opened_.begin() + static_cast<std::ptrdiff_t>(near_.count), kClosed);
    work_ += (node.child[child].isLeaf() ? cost::kLeafMet : cost::kNodeMet) +
             cost::kListed * static_cast<Work>(near_.count - before);
}

/// The last node first: so there are never many.
void PairList::openAll() {
    while (near_.nodeCount > 0 && near_.complete) {
        const NearNode node = near_.nodes[--near_.nodeCount];
        for (std::uint32_t rest = node.closed; rest != 0 && near_.complete; rest &= rest - 1)
            openNode(node, std::countr_zero(rest));
    }
    near_.nodeCount = 0;
}

/// The sides of the tool that look along the planes that hold it, once somebody asks.
struct PairList::Sides {
    std::array<ToolSides::Reach, 6> reach;
    bool measured = false;
};

/// Whether a leaf can be told apart from the whole tool after all: its corners reach less far than its disc, and what
/// touches separates its neighbourhood too.
bool PairList::partLeaf(std::size_t node, int child, const Excursion& excursion, Sides& known) {
    NearNode& near = near_.nodes[node];
    if (!near.child[child].isLeaf()) return false;
    const auto holds = [&](const Vec3f& normal, float gap, float loss) {
        return gap + normal.dot(excursion.start.shift) - loss * excursion.start.perLength >= excursion.start.spare &&
               gap + normal.dot(excursion.end.shift) - loss * excursion.end.perLength >= excursion.end.spare;
    };
    if (((near.exact >> child) & 1U) == 0) {
        near.exact |= 1U << child;
        near.gap[child] = walk_.gapAlong(node, child, tool_->sides()[near.side[child]], near_);
        const Vec3f normal(near.normal[0][child], near.normal[1][child], near.normal[2][child]);
        if (holds(normal, near.gap[child], near.loss[child])) return true;
    }
    if (!known.measured) {
        known.measured = true;
        for (int i = 0; i < excursion.knownCount; ++i)
            known.reach[i] = tool_->sides().across(excursion.known[i], static_cast<float>(skin_.turn));
    }
    for (int i = 0; i < excursion.knownCount; ++i) {
        const ToolSides::Reach& reach = known.reach[i];
        const float gap = walk_.gapAlong(node, child, reach.side, near_);
        if (!holds(reach.side.inward, gap, reach.loss)) continue;
        for (int axis = 0; axis < 3; ++axis) near.normal[axis][child] = reach.side.inward[axis];
        near.gap[child] = gap;
        near.loss[child] = reach.loss;
        return true;
    }
    return false;
}

void PairList::openDoubtful(const Excursion& excursion) {
    Sides known;
    for (std::size_t node = 0; node < near_.nodeCount; ++node) {
        if (near_.nodes[node].closed == 0) continue;
        for (std::uint32_t rest = nodesInDoubt(node, excursion); rest != 0 && near_.complete; rest &= rest - 1) {
            const int child = std::countr_zero(rest);
            if (partLeaf(node, child, excursion, known)) continue;
            near_.nodes[node].closed &= ~(1U << child);
            openNode(near_.nodes[node], child);
        }
    }
}

/// Of a node's children that are closed yet, one bit for each whose slab does not hold at both ends of the step.
std::uint32_t PairList::nodesInDoubt(std::size_t node, const Excursion& excursion) const {
    const NearNode& near = near_.nodes[node];
    const Vec3x8 n = Vec3x8::load(near.normal);
    const Float8 gap = Float8::load(near.gap), loss = Float8::load(near.loss);
    const auto holds = [&](const Excursion::Way& way) {
        const Float8 left = gap + dot(n, everywhere(way.shift)) - loss * Float8::all(way.perLength);
        return lessEqual(Float8::all(way.spare), left);
    };
    return near.closed & ~(holds(excursion.start) & holds(excursion.end));
}

Excursion PairList::excursion(const Pose& start, const Pose& end, double margin, std::span<const Vec3> known) const {
    const double rounding = kFewRoundings * (skin_.length() + skin_.turn * (tool_->centre().norm() + tool_->radius()));
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
    openDoubtful(excursion);
    if (!around_.cover(excursion.start) || !around_.cover(excursion.end)) lookAround(excursion);
    if (around_.looked < near_.count) lookAtNew();
    return std::span(around_.eights).first(around_.count);
}

void PairList::lookAround(const Excursion& excursion) {
    around_.middle = excursion.start;
    around_.middle.spare = std::max(excursion.start.spare, excursion.end.spare) + kAroundSpare;
    const Vec3f step = excursion.end.shift - excursion.start.shift;
    around_.along = kStepsAround * step;
    around_.stray = kStrayAround * step.norm() + kLeastAroundShift;
    around_.turn = kStepsAround * chordBetween(excursion.start, excursion.end) + kLeastAroundTurn;
    around_.count = around_.looked = 0;
}

/// What is left of a slab at the middle is used up by no step that goes less far from there along its normal.
void PairList::lookAtNew() {
    const Float8 stray = Float8::all(around_.stray), turn = Float8::all(around_.turn), zero = Float8::all(0);
    const Vec3x8 back = everywhere(-around_.along);
    const std::size_t first = around_.looked / 8;
    // Of the eight that more have joined since.
    if (around_.count > 0 && around_.eights[around_.count - 1] == 8 * first) --around_.count;
    for (std::size_t i = first; 8 * i < near_.count; ++i) {
        const EightClusters& eight = near_.eights[i];
        const Vec3x8 centre = Vec3x8::load(eight.centre);
        const Float8 closing = stray + max(dot(Vec3x8::load(eight.normal), back), zero);
        const Float8 used = closing + turn * (sqrt(dot(centre, centre)) + Float8::load(eight.radius));
        const std::size_t rest = near_.count - 8 * i;
        const std::uint32_t present = rest >= 8 ? 0xFFU : (1U << rest) - 1U;
        if ((~slabsHold(eight, around_.middle, used) & present) != 0)
            around_.eights[around_.count++] = static_cast<std::uint32_t>(8 * i);
    }
    around_.looked = near_.count;
}

std::uint32_t PairList::clustersInDoubt(std::size_t first, const Excursion& excursion) const {
    const std::size_t rest = near_.count - first;
    const EightClusters& eight = near_.eights[first / 8];
    return ~(slabsHold(eight, excursion.start) & slabsHold(eight, excursion.end)) &
           (rest >= 8 ? 0xFFU : (1U << rest) - 1U);
}

}  // namespace tactooth
