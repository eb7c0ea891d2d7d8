// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/dry_friction.h"

#include <cmath>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

// V. Hayward, B. Armstrong, "A New Computational Model of Friction Applied to Haptic Rendering", Experimental Robotics
// VI, 2000: friction from displacements alone, without drift and without the noise of a differentiated speed. The limit
// is that of a proxy's friction cone (N. Melder, W. S. Harwin, "Extending the Friction Cone Algorithm for Arbitrary
// Polygon Based Haptic Objects", HAPTICS 2004).
//
// Ours differs in two points. The deflection follows the normal of the surface. A turning rim relaxes the deflection,
// because the direction of sliding is then that of the rim and not that of the hand.

namespace tactooth {
namespace {

constexpr double kRelaxationTravel = 0.05;  // mm of rim travel after which the deflection is down to 1/e

}  // namespace

// The proxy's position may be NaN here: the force is then NaN as well, and the force pipeline turns it into a fault.
Vec3 DryFriction::at(const Vec3& proxy, const Vec3& normal, double stiffness, double maxFriction, double rimTravel) {
    TACTOOTH_ASSERT(isUnit(normal));
    TACTOOTH_ASSERT(!(stiffness < 0));
    TACTOOTH_ASSERT(!(maxFriction < 0));
    TACTOOTH_ASSERT(!(rimTravel < 0));
    deflection_ += proxy - last_.value_or(proxy);
    last_ = proxy;
    deflection_ -= deflection_.dot(normal) * normal;
    deflection_ *= std::exp(-rimTravel / kRelaxationTravel);
    const double maxDeflection = stiffness > 0 ? maxFriction / stiffness : 0;
    const double length = deflection_.norm();
    if (length > maxDeflection) deflection_ *= maxDeflection / length;
    TACTOOTH_ASSERT(!(std::abs(deflection_.dot(normal)) > 2 * kUnitLengthTolerance * length + 1e-12));
    TACTOOTH_ASSERT(!(stiffness * deflection_.norm() > maxFriction * (1 + 1e-9)));
    return -stiffness * deflection_;
}

void DryFriction::reset() {
    last_.reset();
    deflection_.setZero();
}

}  // namespace tactooth
