// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/dry_friction.h"

#include <cmath>

// V. Hayward, B. Armstrong, "A New Computational Model of Friction Applied to Haptic Rendering", Experimental Robotics
// VI, 2000: friction from displacements alone, free of drift and of the noise that a derived speed carries. The limit
// is that of a proxy's friction cone (N. Melder, W. S. Harwin, "Extending the Friction Cone Algorithm for Arbitrary
// Polygon Based Haptic Objects", HAPTICS 2004). Differs: it follows the surface's normal, and a turning rim tears it
// off, because the direction of sliding is then that of the rim and not that of the hand.

namespace tactooth {
namespace {

constexpr double kTearOff = 0.05;  // mm that a rim travels until what it clung to is down to 1/e

}  // namespace

Vec3 DryFriction::at(const Vec3& proxy, const Vec3& normal, double stiffness, double most, double rimTravel) {
    deflection_ += proxy - last_.value_or(proxy);
    last_ = proxy;
    deflection_ -= deflection_.dot(normal) * normal;
    deflection_ *= std::exp(-rimTravel / kTearOff);
    const double longest = stiffness > 0 ? most / stiffness : 0;
    const double length = deflection_.norm();
    if (length > longest) deflection_ *= longest / length;
    return -stiffness * deflection_;
}

void DryFriction::reset() {
    last_.reset();
    deflection_.setZero();
}

}  // namespace tactooth
