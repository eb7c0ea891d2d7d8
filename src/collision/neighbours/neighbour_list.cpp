// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/neighbours/neighbour_list.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "collision/narrow/gjk.h"

// Verlet list: L. Verlet, "Computer Experiments on Classical Fluids", Phys. Rev. 159, 1967. Differs from the paper:
// each entry has a separating direction with its gap, so a motion along the surface, or away from it, does not use up
// the gap. A rotation counts by its lever arm. And the levels below are filled in on demand. Within the list, a shorter
// one serves a few steps, as in S. Pall et al., "Heterogeneous parallelization and acceleration of molecular dynamics
// simulations in GROMACS", J. Chem. Phys. 153, 2020 (a list in two levels).

namespace tactooth {
namespace {

constexpr std::size_t kManyClusters = 1024;  // a longer list costs more to build and test than two lists
constexpr double kMinReach = 0.001;          // of the tool's radius: 10 um for a bur of 20 mm with its shank
constexpr double kMaxReach = 1.0;            // of the tool's radius

// The local candidates serve a few steps like the present one, and others that deviate from it by some share of it, by
// some micrometres and by 20 arc seconds.
constexpr float kStepsAround = 4;
constexpr float kDeviationAround = 0.25F;
constexpr float kLeastAroundShift = 0.002F;  // mm
constexpr float kLeastAroundTurn = 1e-4F;    // chord
constexpr float kAroundSpare = 1e-5F;        // mm: the least width of slabs grows with the distance from the origin

/// The first in lanes 0-3, the second in lanes 4-7.
Vec3x8 sideBySide(const Vec3f& a, const Vec3f& b) {
    float lanes[3][8];
    for (int axis = 0; axis < 3; ++axis) {
        std::fill_n(lanes[axis], 4, a[axis]);
        std::fill_n(lanes[axis] + 4, 4, b[axis]);
    }
    return Vec3x8::load(lanes);
}

/// One bit for each of eight clusters whose slab stays wide enough when the tool is moved by `displacement`. `used`:
/// the width that it must keep in addition, mm.
std::uint32_t slabsHold(const ClusterPacket& packet, const ToolMotion::Displacement& displacement, Float8 used) {
    const Vec3x8 n = Vec3x8::load(packet.normal);
    const Vec3x8 turned = {dot(n, broadcast(displacement.turn.col(0))), dot(n, broadcast(displacement.turn.col(1))),
                           dot(n, broadcast(displacement.turn.col(2)))};
    const Float8 left =
        Float8::load(packet.gap) + dot(n, broadcast(displacement.shift)) + dot(turned, Vec3x8::load(packet.centre));
    return lessEqual(
        Float8::load(packet.radius) * Float8::all(displacement.perLength) + Float8::all(displacement.spare),
        left - used);
}
std::uint32_t slabsHold(const ClusterPacket& packet, const ToolMotion::Displacement& displacement) {
    return slabsHold(packet, displacement, Float8::all(0));
}

/// The rotation between two displacements as a chord.
float chordBetween(const ToolMotion::Displacement& a, const ToolMotion::Displacement& b) {
    return (a.turn - b.turn).norm() * std::numbers::sqrt2_v<float> / 2;
}

}  // namespace

NeighbourList::NeighbourList(const ToolShape& tool, std::size_t capacity) : tool_(&tool), near_(0) {
    reserve(capacity);
    forget();
}

void NeighbourList::forget() {
    clear();
    near_.count = 0;
    cap_ = kMaxReach * tool_->radius();
}

double NeighbourList::leastAround() const { return kMinReach * tool_->radius(); }

bool NeighbourList::isLong() const { return 2 * near_.count > kManyClusters; }

double NeighbourList::leastRotation() { return kMinReach; }

void NeighbourList::make(const Surface& surface, const Pose& toolInTooth, const ContactMargin& wanted) {
    TACTOOTH_ASSERT(surface.base != nullptr);
    TACTOOTH_ASSERT(wanted.along.allFinite() && wanted.around >= 0 && wanted.turn >= 0);
    if (4 * near_.count > kManyClusters) cap_ = std::min(cap_, contactMargin_.length());
    contactMargin_ = {wanted.along, std::max(wanted.around, leastAround()), std::max(wanted.turn, leastRotation())};
    shortenTo(cap_);
    cap_ = std::min(2 * cap_, kMaxReach * tool_->radius());
    work_ += cost::kList;
    list(surface, toolInTooth, isShortest() ? near_.capacity() : kManyClusters);
}

bool NeighbourList::isShortest() const {
    return contactMargin_.along.isZero() && contactMargin_.around <= leastAround() &&
           contactMargin_.turn <= leastRotation();
}

bool NeighbourList::shorten() {
    TACTOOTH_ASSERT(isFull());
    clear();
    cap_ = contactMargin_.length() / 2;
    return !isShortest();
}

/// Shortens the contact margin to a length (mm), or to the least one.
void NeighbourList::shortenTo(double length) {
    TACTOOTH_ASSERT(length >= 0);
    const double now = contactMargin_.length();
    if (now <= length) return;
    contactMargin_.along *= length / now;
    contactMargin_.around = std::max(leastAround(), contactMargin_.around * length / now);
    contactMargin_.turn = std::max(leastRotation(), contactMargin_.turn * length / now);
    if (contactMargin_.along.norm() < leastAround()) contactMargin_.along.setZero();
}

void NeighbourList::buildAll(const Surface& surface, const Pose& toolInTooth, const ContactMargin& contactMargin) {
    TACTOOTH_ASSERT(contactMargin.along.allFinite() && contactMargin.around >= 0 && contactMargin.turn >= 0);
    contactMargin_ = contactMargin;
    list(surface, toolInTooth, near_.capacity());
    openAll();
    while (!near_.complete) {
        reserve(std::max(4 * near_.capacity(), kUsualCapacity));
        list(surface, toolInTooth, near_.capacity());
        openAll();
    }
    work_ = 0;  // no move waits for it
    TACTOOTH_ASSERT(near_.complete && near_.nodeCount == 0);
}

void NeighbourList::buildWithinCapacity(const Surface& surface, const Pose& toolInTooth, const ContactMargin& wanted,
                                        double least, double most) {
    TACTOOTH_ASSERT(least > 0 && most > 0);
    contactMargin_ = wanted;
    shortenTo(std::max(least, most));
    list(surface, toolInTooth, near_.capacity());
    openAll();
    for (double length = contactMargin_.length(); !near_.complete && length > least;) {
        length = std::max(length / 2, least);
        shortenTo(length);
        list(surface, toolInTooth, near_.capacity());
        openAll();
    }
    if (!near_.complete) buildAll(surface, toolInTooth, contactMargin_);
    work_ = 0;
}

bool NeighbourList::buildUpTo(const Surface& surface, const Pose& toolInTooth, std::size_t limit) {
    TACTOOTH_ASSERT(limit > 0);
    contactMargin_ = {};
    if (limit > near_.capacity()) reserve(limit);
    list(surface, toolInTooth, limit);
    openAll();
    work_ = 0;
    return near_.complete;
}

void NeighbourList::reserve(std::size_t capacity) {
    near_ = NearClusters(capacity);
    around_.packets.resize(near_.packets.size());
    pairs_.resize(capacity / 4);
    opened_.resize(capacity);
}

void NeighbourList::list(const Surface& surface, const Pose& toolInTooth, std::size_t limit) {
    TACTOOTH_ASSERT(toolInTooth.position.allFinite());
    TACTOOTH_ASSERT(std::abs(toolInTooth.rotation.norm() - 1) < 1e-6);
    at_ = toolInTooth;
    rotation_ = at_.rotation.toRotationMatrix();
    limit_ = limit;
    openedCount_ = recentCount_ = 0;
    around_.deviation = around_.turn = -1;
    made_ = true;
    traversal_.begin(surface, *tool_, at_, contactMargin_, near_);
}

void NeighbourList::openNode(const NearNode& node, int child) {
    TACTOOTH_ASSERT(child >= 0 && child < AabbTree::kWidth);
    const std::size_t before = near_.count;
    traversal_.open(node, child, limit_, near_);
    TACTOOTH_ASSERT(near_.count >= before && near_.count <= limit_);
    std::fill(opened_.begin() + static_cast<std::ptrdiff_t>(before),
              opened_.begin() + static_cast<std::ptrdiff_t>(near_.count), kClosed);
    work_ += (node.child[child].isLeaf() ? cost::kLeafMet : cost::kNodeMet) +
             cost::kListed * static_cast<Work>(near_.count - before);
}

/// Opens all nodes, the last one first, so there are never many.
void NeighbourList::openAll() {
    while (near_.nodeCount > 0 && near_.complete) {
        const NearNode node = near_.nodes[--near_.nodeCount];
        for (std::uint32_t rest = node.closed; rest != 0 && near_.complete; rest &= rest - 1)
            openNode(node, std::countr_zero(rest));
    }
    near_.nodeCount = 0;
}

/// The tool's support planes along the known directions, computed on demand.
struct NeighbourList::KnownPlanes {
    std::array<SupportPlanes::Reach, 6> reach;
    bool measured = false;
};

/// Whether a leaf of the tooth is separated from the whole tool after all: by its corners instead of its disc, or by a
/// known direction. (A plane that separates a contact often separates its neighbourhood.)
bool NeighbourList::separateLeaf(std::size_t node, int child, const ToolMotion& motion, KnownPlanes& known) {
    TACTOOTH_ASSERT(node < near_.nodeCount);
    NearNode& near = near_.nodes[node];
    if (!near.child[child].isLeaf()) return false;
    const auto holds = [&](const Vec3f& normal, float gap, float loss) {
        return gap + normal.dot(motion.start.shift) - loss * motion.start.perLength >= motion.start.spare &&
               gap + normal.dot(motion.end.shift) - loss * motion.end.perLength >= motion.end.spare;
    };
    if (((near.exact >> child) & 1U) == 0) {
        near.exact |= 1U << child;
        near.gap[child] = traversal_.gapAlong(node, child, tool_->supportPlanes()[near.plane[child]], near_);
        const Vec3f normal(near.normal[0][child], near.normal[1][child], near.normal[2][child]);
        if (holds(normal, near.gap[child], near.loss[child])) return true;
    }
    if (!known.measured) {
        known.measured = true;
        for (int i = 0; i < motion.knownCount; ++i)
            known.reach[i] = tool_->supportPlanes().across(motion.known[i], static_cast<float>(contactMargin_.turn));
    }
    for (int i = 0; i < motion.knownCount; ++i) {
        const SupportPlanes::Reach& reach = known.reach[i];
        const float gap = traversal_.gapAlong(node, child, reach.plane, near_);
        if (!holds(reach.plane.inward, gap, reach.loss)) continue;
        for (int axis = 0; axis < 3; ++axis) near.normal[axis][child] = reach.plane.inward[axis];
        near.gap[child] = gap;
        near.loss[child] = reach.loss;
        return true;
    }
    return false;
}

void NeighbourList::openUncertain(const ToolMotion& motion) {
    KnownPlanes known;
    for (std::size_t node = 0; node < near_.nodeCount; ++node) {
        if (near_.nodes[node].closed == 0) continue;
        for (std::uint32_t rest = uncertainNodes(node, motion); rest != 0 && near_.complete; rest &= rest - 1) {
            const int child = std::countr_zero(rest);
            if (separateLeaf(node, child, motion, known)) continue;
            near_.nodes[node].closed &= ~(1U << child);
            openNode(near_.nodes[node], child);
        }
    }
}

/// Of the unopened children of a node: one bit for each whose slab is not wide enough at both ends of the step.
std::uint32_t NeighbourList::uncertainNodes(std::size_t node, const ToolMotion& motion) const {
    const NearNode& near = near_.nodes[node];
    const Vec3x8 n = Vec3x8::load(near.normal);
    const Float8 gap = Float8::load(near.gap), loss = Float8::load(near.loss);
    const auto holds = [&](const ToolMotion::Displacement& displacement) {
        const Float8 left = gap + dot(n, broadcast(displacement.shift)) - loss * Float8::all(displacement.perLength);
        return lessEqual(Float8::all(displacement.spare), left);
    };
    return near.closed & ~(holds(motion.start) & holds(motion.end));
}

ToolMotion NeighbourList::motion(const Pose& start, const Pose& end, double margin, std::span<const Vec3> known) const {
    TACTOOTH_ASSERT(made_);
    TACTOOTH_ASSERT(known.size() <= std::tuple_size_v<decltype(ToolMotion::known)>);
    TACTOOTH_ASSERT(margin >= 0);
    const double rounding =
        kFewRoundings * (contactMargin_.length() + contactMargin_.turn * (tool_->centre().norm() + tool_->radius()));
    const auto displacement = [&](const Pose& pose, double spare) {
        const Mat3 turn = rotation_.transpose() * pose.rotation.toRotationMatrix() - Mat3::Identity();
        const Vec3 shift = rotation_.transpose() * (pose.position - at_.position);
        const double perLength = chordBetween(pose.rotation, at_.rotation) * (1 + kFewRoundings);
        return ToolMotion::Displacement{turn.cast<float>(), shift.cast<float>(), static_cast<float>(perLength),
                                        static_cast<float>(spare + rounding)};
    };
    ToolMotion result;
    result.start = displacement(start, 0);
    result.end = displacement(end, margin);
    result.knownCount = static_cast<int>(known.size());
    for (int i = 0; i < 3; ++i) result.column[i] = sideBySide(result.start.turn.col(i), result.end.turn.col(i));
    result.column[0].x = result.column[0].x + Float8::all(1);
    result.column[1].y = result.column[1].y + Float8::all(1);
    result.column[2].z = result.column[2].z + Float8::all(1);
    result.shift = sideBySide(result.start.shift, result.end.shift);
    for (std::size_t i = 0; i < known.size(); ++i) result.known[i] = (rotation_.transpose() * known[i]).cast<float>();
    return result;
}

bool NeighbourList::LocalCandidates::cover(const ToolMotion::Displacement& displacement) const {
    const Vec3f shift = displacement.shift - middle.shift;
    const float squared = along.squaredNorm();
    const float share = squared > 0 ? std::clamp(shift.dot(along) / squared, 0.0F, 1.0F) : 0.0F;
    return (shift - share * along).norm() <= deviation && chordBetween(displacement, middle) <= turn &&
           displacement.spare <= middle.spare;
}

std::span<const std::uint32_t> NeighbourList::within(const ToolMotion& motion) {
    TACTOOTH_ASSERT(made_);
    openUncertain(motion);
    if (!around_.cover(motion.start) || !around_.cover(motion.end)) searchAround(motion);
    if (around_.tested < near_.count) testNewClusters();
    TACTOOTH_ASSERT(around_.count <= (near_.count + 7) / 8);
    return std::span(around_.packets).first(around_.count);
}

void NeighbourList::searchAround(const ToolMotion& motion) {
    around_.middle = motion.start;
    around_.middle.spare = std::max(motion.start.spare, motion.end.spare) + kAroundSpare;
    const Vec3f step = motion.end.shift - motion.start.shift;
    around_.along = kStepsAround * step;
    around_.deviation = kDeviationAround * step.norm() + kLeastAroundShift;
    around_.turn = kStepsAround * chordBetween(motion.start, motion.end) + kLeastAroundTurn;
    around_.count = around_.tested = 0;
}

/// Tests the clusters that are new. A step that moves less along the normal of a slab than the slab is wide cannot
/// close it.
void NeighbourList::testNewClusters() {
    const Float8 deviation = Float8::all(around_.deviation), turn = Float8::all(around_.turn), zero = Float8::all(0);
    const Vec3x8 back = broadcast(-around_.along);
    const std::size_t first = around_.tested / 8;
    // The last packet may have got more clusters since.
    if (around_.count > 0 && around_.packets[around_.count - 1] == 8 * first) --around_.count;
    for (std::size_t i = first; 8 * i < near_.count; ++i) {
        const ClusterPacket& packet = near_.packets[i];
        const Vec3x8 centre = Vec3x8::load(packet.centre);
        const Float8 closing = deviation + max(dot(Vec3x8::load(packet.normal), back), zero);
        const Float8 used = closing + turn * (sqrt(dot(centre, centre)) + Float8::load(packet.radius));
        const std::size_t rest = near_.count - 8 * i;
        const std::uint32_t present = rest >= 8 ? 0xFFU : (1U << rest) - 1U;
        if ((~slabsHold(packet, around_.middle, used) & present) != 0)
            around_.packets[around_.count++] = static_cast<std::uint32_t>(8 * i);
    }
    around_.tested = near_.count;
}

std::uint32_t NeighbourList::uncertainClusters(std::size_t first, const ToolMotion& motion) const {
    TACTOOTH_ASSERT(first % 8 == 0 && first < near_.count);
    const std::size_t rest = near_.count - first;
    const ClusterPacket& packet = near_.packets[first / 8];
    return ~(slabsHold(packet, motion.start) & slabsHold(packet, motion.end)) & (rest >= 8 ? 0xFFU : (1U << rest) - 1U);
}

}  // namespace tactooth
