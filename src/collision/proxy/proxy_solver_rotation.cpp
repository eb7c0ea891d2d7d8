// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "collision/narrow/gjk.h"
#include "collision/proxy/proxy_solver_iteration.h"

// Six degrees of freedom: M. Ortega, S. Redon, S. Coquillart, "A Six Degree-of-Freedom God-Object Method for Haptic
// Display of Rigid Bodies with Surface Properties", IEEE TVCG 13(3), 2007, section 4 (Gauss' principle: of all moves
// that the contacts allow, the nearest to the free one in the metric of the kinetic energy). Differs from the paper: a
// contact bounds the place of a corner of the tool along a plane, not its acceleration, and is made linear anew where
// an attempted turn has bent the corner's way.

namespace tactooth {
namespace {

constexpr int kMaxTries =
    3;  // to make a pair of features linear: then the whole triangle is kept in front of its plane

Quat rotationBy(const Vec3& turn) {
    const double angle = turn.norm();
    return angle > 0 ? Quat(Eigen::AngleAxisd(angle, turn / angle)) : Quat::Identity();
}

/// The shorter of the two ways round.
Vec3 rotationBetween(const Quat& from, const Quat& to) {
    const Quat between = to * from.conjugate();
    const double sine = between.vec().norm();
    if (!(sine > 0)) return Vec3::Zero();
    const double half = std::atan2(sine, std::abs(between.w()));
    return (between.w() < 0 ? -2 : 2) * half / sine * between.vec();
}

Vec6 asVec6(const Vec3& shift, const Vec3& turn) {
    Vec6 both;
    both.head<3>() = shift;
    both.tail<3>() = turn;
    return both;
}

}  // namespace

double ProxySolver::characteristicLength() const { return tool_->radius() / std::numbers::sqrt3; }

/// Sets the end of the attempted step: the tool's centre shifted, and the tool turned about it.
void ProxySolver::moveTo(const Vec3& shift, const Vec3& turn, Attempt& attempt) const {
    attempt.shift = shift;
    attempt.turn = turn;
    attempt.rotation = (rotationBy(turn) * pose_.rotation).normalized();
    attempt.matrix = attempt.rotation.toRotationMatrix();
    attempt.step = shift + (attempt.startMatrix - attempt.matrix) * tool_->centre();
}

/// Whether a plane that turns on the way keeps the triangle of the tool from the tooth: its normal goes straight from
/// n0, which parts them at the start, to n1, which parts them at the end. A tool that rocks on an edge of the tooth
/// sweeps through that edge as far as the hull of its corners can tell, but not through this plane.
///
/// With corners q that go straight from q0 to q1, the distance from a corner p of the tooth along the normal is a
/// polynomial of the second degree in time, positive if its three Bernstein coefficients are: n0 (q0 - p), n1 (q1 - p)
/// and n0 (q1 - p) + n1 (q0 - p).
bool ProxySolver::separatedByRotatingPlane(const Triangle3& tooth, const SweptTool& swept) {
    const auto start = std::span<const Vec3>(swept.corners).first(3);
    const auto end = std::span<const Vec3>(swept.corners).last(3);
    const GjkResult first = distanceBetween(tooth, start, start[0] - tooth[0]);
    if (!first.separated) return false;
    const GjkResult last = distanceBetween(tooth, end, first.normal);
    distances_ += 2;
    if (last.gap < margin_ / 2) return false;
    for (const Vec3& p : tooth) {
        for (int i = 0; i < 3; ++i) {
            if (first.normal.dot(end[i] - p) + last.normal.dot(start[i] - p) < 0) return false;
        }
    }
    return true;
}

/// How far two features are apart with the tool at `toolInTooth`; a corner of the tool from the pair's plane where the
/// features have no normal of their own.
FeatureGap ProxySolver::gapOf(const WatchedPair& watched, const FeaturePair& features, const Pose& toolInTooth) const {
    const Triangle3 tooth = cornersOf(partOf(*surface_, watched.pair.part).mesh(), watched.pair.tooth);
    const Triangle3 tool = tool_->cornersAt(toolInTooth, watched.pair.tool);
    const Vec3& normal = watched.plane.normal;
    if (const auto gap = gapBetween(features, tooth, tool, normal)) return *gap;
    return {normal.dot(tool[features.tool]) - watched.plane.offset, normal, tool[features.tool]};
}

/// The corner of the tool's triangle that the attempt brings nearest to the plane that parts the pair.
FeaturePair ProxySolver::lowestCorner(const Attempt& attempt, const WatchedPair& watched) const {
    const Triangle3 tool = tool_->corners(watched.pair.tool);
    const Vec3 inTool = attempt.matrix.transpose() * watched.plane.normal;
    const auto lowest = std::min_element(tool.begin(), tool.end(),
                                         [&](const Vec3& p, const Vec3& q) { return p.dot(inTool) < q.dot(inTool); });
    return {FeaturePair::Kind::CornerOverPlane, 0, static_cast<int>(lowest - tool.begin())};
}

/// Of the features of a pair that could meet, those that the attempt brings nearest; none if it brings none too near.
std::optional<FeaturePair> ProxySolver::blockingFeatures(const Attempt& attempt, const WatchedPair& watched) const {
    const Triangle3 tooth = cornersOf(partOf(*surface_, watched.pair.part).mesh(), watched.pair.tooth);
    const ContactFeatures touching(tooth, tool_->cornersAt(pose_, watched.pair.tool), watched.plane.normal);
    const Pose end{pose_.position + attempt.step, attempt.rotation};
    std::optional<FeaturePair> nearest;
    double least = margin_ / 2;
    for (int i = 0; i < touching.count; ++i) {
        if (gapOf(watched, touching.pairs[i], pose_).gap < margin_ / 2) continue;  // they do not face each other
        const double gap = gapOf(watched, touching.pairs[i], end).gap;
        if (gap < least) least = gap, nearest = touching.pairs[i];
    }
    return nearest;
}

/// Whether features that held the tool may still do so at the present pose: it may have slid off them.
bool ProxySolver::stillTouch(const WatchedPair& watched, const FeaturePair& features) const {
    const Triangle3 tooth = cornersOf(partOf(*surface_, watched.pair.part).mesh(), watched.pair.tooth);
    const ContactFeatures touching(tooth, tool_->cornersAt(pose_, watched.pair.tool), watched.plane.normal);
    const auto end = touching.pairs.begin() + touching.count;
    return std::find(touching.pairs.begin(), end, features) != end;
}

/// Where features of a pair are already kept apart in an attempt; its number of planes: nowhere.
int ProxySolver::placeOf(const Attempt& attempt, const WatchedPair& watched, const FeaturePair& features) {
    int place = 0;
    while (place < attempt.planeCount &&
           !(attempt.watched[place].pair == watched.pair && attempt.touches[place].features == features)) {
        ++place;
    }
    return place;
}

/// What of a pair to keep apart for the attempt not to bring it together.
FeaturePair ProxySolver::featuresToConstrain(const Attempt& attempt, const WatchedPair& watched) const {
    if (const auto inTheWay = blockingFeatures(attempt, watched)) {
        const int place = placeOf(attempt, watched, *inTheWay);
        if (place == attempt.planeCount || attempt.touches[place].tries < kMaxTries) return *inTheWay;
    }
    return lowestCorner(attempt, watched);
}

/// Keeps a pair apart that the attempt would bring together. Where none of its features are in the way, the turn may be
/// too long for a plane to be found that parts them: then a turn is tried that bends the way by less than the margin.
void ProxySolver::addRotatingConstraint(Attempt& attempt, const WatchedPair& watched) const {
    const FeaturePair features = featuresToConstrain(attempt, watched);
    const double straight = std::sqrt(margin_ / tool_->radius());
    if (features.kind == FeaturePair::Kind::CornerOverPlane && attempt.turn.norm() > straight) {
        attempt.rotationBound = straight;
    } else {
        addFeatureConstraint(attempt, watched, features);
    }
}

/// Adds a plane for two features; linear in shift and turn. A turn bends the way: where it bends away, the slope at the
/// start of the attempt keeps the features apart, else that at its end.
void ProxySolver::addFeatureConstraint(Attempt& attempt, const WatchedPair& watched,
                                       const FeaturePair& features) const {
    const int place = placeOf(attempt, watched, features);
    const bool isNew = place >= attempt.planeCount;
    if (isNew) ++attempt.planeCount;
    const Vec3 centre = pose_ * tool_->centre();
    const auto slopeOf = [&](const FeatureGap& gap, const Vec3& about) {
        return asVec6(gap.normal, (gap.point - about).cross(gap.normal) / characteristicLength());
    };
    const FeatureGap here = gapOf(watched, features, pose_);
    const FeatureGap there = gapOf(watched, features, {pose_.position + attempt.step, attempt.rotation});
    HalfSpace6 space;
    space.normal = slopeOf(there, centre + attempt.shift);
    space.offset = margin_ - there.gap + space.normal.dot(asVec6(attempt.shift, attempt.turn * characteristicLength()));
    if (space.offset > margin_ - here.gap) space = {slopeOf(here, centre), margin_ - here.gap};
    // Staying put is always allowed: a gap that rounding has left below the margin may stay so.
    space.offset = std::min(0.0, space.offset);
    attempt.watched[place] = watched;
    attempt.touches[place] = {features, isNew ? 1 : attempt.touches[place].tries + 1, there.normal, there.point};
    attempt.halfSpaces6[place] = space;
}

/// The shift and the turn nearest to those of the goal under the planes met so far.
Qp6Result ProxySolver::nearestRotating(const Attempt& attempt) const {
    const Vec3 centre = tool_->centre();
    const Vec6 wanted = asVec6(attempt.goal * centre - pose_ * centre,
                               rotationBetween(pose_.rotation, attempt.goal.rotation) * characteristicLength());
    const std::span<const HalfSpace6> planes(attempt.halfSpaces6.data(), static_cast<std::size_t>(attempt.planeCount));
    return solveQp6(planes, wanted, margin_ * kSolved);
}

/// The way of the tip in this tick, more or less, as far as the contacts of the last tick let the tool shift and turn.
/// `turn` becomes how far it will turn.
Vec3 ProxySolver::predictedShift(Attempt& attempt, double& turn) {
    attempt.startMatrix = pose_.rotation.toRotationMatrix();
    restart(attempt);
    const Qp6Result answer = nearestRotating(attempt);
    if (!answer.feasible) return Vec3::Zero();
    moveTo(answer.point.head<3>(), answer.point.tail<3>() / characteristicLength(), attempt);
    turn = chordBetween(attempt.rotation, pose_.rotation);
    return attempt.step;
}

/// The same, shortened to what is allowed.
bool ProxySolver::solveRotating(Attempt& attempt) const {
    const Qp6Result answer = nearestRotating(attempt);
    if (!answer.feasible) return false;
    attempt.setActive(answer);
    const Vec3 shift = answer.point.head<3>();
    const Vec3 turn = answer.point.tail<3>() / characteristicLength();
    const double share = shareAllowed(shift, turn, attempt);
    attempt.clipped = share < 1;
    moveTo(share * shift, share * turn, attempt);
    return true;
}

/// How much of a move the allowance and the list of what is near leave. (With a move, each part of it is allowed too.)
double ProxySolver::shareAllowed(const Vec3& shift, const Vec3& turn, Attempt& attempt) const {
    const double length = shift.norm() + turn.norm() * tool_->radius();
    double afar = length > attempt.allowance ? attempt.allowance / length : 1;
    if (afar * turn.norm() > attempt.rotationBound) afar = attempt.rotationBound / turn.norm();
    const auto isCovered = [&](double share) {
        moveTo(share * shift, share * turn, attempt);
        return isListed(pose_.position + attempt.step) &&
               chordBetween(attempt.rotation, pose_.rotation) <= attempt.rotationLeft;
    };
    attempt.clippedToList = !isCovered(afar);
    if (!attempt.clippedToList) return afar;
    double inside = 0;
    double outside = afar;
    for (int i = 0; i < 10; ++i) {
        const double middle = (inside + outside) / 2;
        (isCovered(middle) ? inside : outside) = middle;
    }
    return inside;
}

}  // namespace tactooth
