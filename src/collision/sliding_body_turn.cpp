// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/sliding_body_round.h"

// Six degrees of freedom: M. Ortega, S. Redon, S. Coquillart, "A Six Degree-of-Freedom God-Object Method for Haptic
// Display of Rigid Bodies with Surface Properties", IEEE TVCG 13(3), 2007, section 4 (Gauss' principle: of all moves
// that the contacts allow, the nearest to the free one in the metric of the kinetic energy). Differs from the paper: a
// contact bounds the place of a corner of the tool along a plane, not its acceleration, and is made linear anew where
// an attempted turn has bent the corner's way.

namespace tactooth {
namespace {

Quat rotationBy(const Vec3& turn) {
    const double angle = turn.norm();
    return angle > 0 ? Quat(Eigen::AngleAxisd(angle, turn / angle)) : Quat::Identity();
}

/// The shorter of the two ways round.
Vec3 turnBetween(const Quat& from, const Quat& to) {
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

double SlidingBody::turnLength() const { return tool_->radius() / std::numbers::sqrt3; }

/// Sets the end of the attempted step: the tool's centre shifted, and the tool turned about it.
void SlidingBody::moveTo(const Vec3& shift, const Vec3& turn, Attempt& attempt) const {
    attempt.shift = shift;
    attempt.turn = turn;
    attempt.rotation = (rotationBy(turn) * pose_.rotation).normalized();
    attempt.matrix = attempt.rotation.toRotationMatrix();
    attempt.step = shift + (attempt.startMatrix - attempt.matrix) * tool_->centre();
}

/// A plane in front of the corner of the tool's triangle that stands lowest over it at the end of the attempt; linear
/// in the shift and the turn around that end.
void SlidingBody::addTurningConstraint(Attempt& attempt, const WatchedPair& watched) const {
    const Vec3& normal = watched.plane.normal;
    const Triangle3 tool = tool_->corners(watched.pair.tool);
    const Vec3 inTool = attempt.matrix.transpose() * normal;
    const auto lowest = std::min_element(tool.begin(), tool.end(),
                                         [&](const Vec3& p, const Vec3& q) { return p.dot(inTool) < q.dot(inTool); });
    const int corner = static_cast<int>(lowest - tool.begin());
    const Vec3 lever = attempt.matrix * (*lowest - tool_->centre());
    const Vec3 moment = lever.cross(normal);
    const double gap = gapAt(watched, attempt.matrix, pose_.position + attempt.step);
    // Staying put is always allowed: a gap that rounding, or the bend of the way, has left below the margin may stay
    // so.
    const double offset = std::min(0.0, margin_ - gap + normal.dot(attempt.shift) + moment.dot(attempt.turn));
    int place = 0;
    while (place < attempt.planeCount &&
           !(attempt.watched[place].pair == watched.pair && attempt.watched[place].corner == corner)) {
        ++place;
    }
    attempt.planeCount = std::max(attempt.planeCount, place + 1);
    attempt.watched[place] = watched;
    attempt.watched[place].corner = corner;
    attempt.turnSpaces[place] = {asVec6(normal, moment / turnLength()), offset};
}

/// The shift and the turn nearest to those of the goal under the planes met so far, shortened to what is allowed.
bool SlidingBody::solveTurning(Attempt& attempt) const {
    const Vec3 centre = tool_->centre();
    const Vec6 wanted = asVec6(attempt.goal * centre - pose_ * centre,
                               turnBetween(pose_.rotation, attempt.goal.rotation) * turnLength());
    const std::span<const HalfSpace6> planes(attempt.turnSpaces.data(), static_cast<std::size_t>(attempt.planeCount));
    const NearestInPolyhedron6 answer = nearestInPolyhedron6(planes, wanted, margin_ * kSolved);
    if (!answer.feasible) return false;
    attempt.setActive(answer);
    const Vec3 shift = answer.point.head<3>();
    const Vec3 turn = answer.point.tail<3>() / turnLength();
    const double share = shareAllowed(shift, turn, attempt);
    attempt.clipped = share < 1;
    moveTo(share * shift, share * turn, attempt);
    return true;
}

/// How much of a move the allowance and the list of what is near leave. (With a move, each part of it is allowed too.)
double SlidingBody::shareAllowed(const Vec3& shift, const Vec3& turn, Attempt& attempt) const {
    const double length = shift.norm() + turn.norm() * tool_->radius();
    const double afar = length > attempt.allowance ? attempt.allowance / length : 1;
    const auto isCovered = [&](double share) {
        moveTo(share * shift, share * turn, attempt);
        return isListed(pose_.position + attempt.step) &&
               chordBetween(attempt.rotation, pose_.rotation) <= attempt.turnLeft;
    };
    attempt.outgrown = !isCovered(afar);
    if (!attempt.outgrown) return afar;
    double inside = 0;
    double outside = afar;
    for (int i = 0; i < 10; ++i) {
        const double middle = (inside + outside) / 2;
        (isCovered(middle) ? inside : outside) = middle;
    }
    return inside;
}

}  // namespace tactooth
