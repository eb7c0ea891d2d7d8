// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/contact_force.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"

// Kelvin-Voigt contact: W. Fluegge, "Viscoelasticity", 1975, section 1.3: F = k * d + c * d'. Ours differs in two
// points: the force never pulls, and the material blends at a border. Friction has the same stiffness, so that a proxy
// held by friction pulls straight from the device to the proxy.
//
// Positions, velocities and multipliers may be NaN here; the asserts let NaN pass, and the force pipeline finds the
// fault.

namespace tactooth {
namespace {

// Travel after which the share of the old material falls to 1/e, mm: to 5 % within 50 um. The blend is exponential,
// because it depends on the travel alone: one long tick gives the same as many short ones.
constexpr double kBlendTravel = 0.05 / 3;
// A hand that crosses a border fast, or deep, must not feel a step. The blend changes the force by at most this, N/s:
// in a millisecond about as much as a hand just feels at 10 Hz and more (0.03 to 0.05 N).
constexpr double kBlendSlew = 50;

}  // namespace

ContactForce::ContactForce(const MaterialTable& materials) : materials_(materials) {
    for (const MaterialId id : materials.registry().ids()) hardest_ = std::max(hardest_, materials[id].stiffness);
    TACTOOTH_ASSERT(hardest_ >= 0);
}

ContactForce::SurfaceProperties ContactForce::propertiesOf(const ContactState& contact) const {
    TACTOOTH_ASSERT(!contact.held.empty());
    SurfaceProperties sums{0, 0, 0};
    double weights = 0;
    for (const ContactPoint& held : contact.held) {
        TACTOOTH_ASSERT(static_cast<std::size_t>(held.material) < materials_.registry().size());
        TACTOOTH_ASSERT(!(held.multiplier < 0));
        const Material& material = materials_[held.material];
        const double weight = std::max(held.multiplier, 1e-12);  // a contact without depth still has a material
        sums.stiffness += weight * material.stiffness;
        sums.damping += weight * material.damping;
        sums.friction += weight * material.friction;
        weights += weight;
    }
    TACTOOTH_ASSERT(!(weights <= 0));
    return {sums.stiffness / weights, sums.damping / weights, sums.friction / weights};
}

/// Stiffness that is rendered, before `scale_`, N/mm.
double ContactForce::stiffnessOf(const SurfaceProperties& properties) const {
    if (!std::isfinite(maxStiffness_)) return overrides_.stiffness.value_or(properties.stiffness);
    const double softened =
        hardest_ > maxStiffness_ ? properties.stiffness * maxStiffness_ / hardest_ : properties.stiffness;
    const double spring = overrides_.stiffness.value_or(softened);
    const double bounded = scale_ > 0 ? std::min(spring, maxStiffness_ / scale_) : spring;
    TACTOOTH_ASSERT(!(scale_ * bounded > maxStiffness_ * (1 + 1e-9)));
    return bounded;
}

void ContactForce::setScale(double scale) {
    TACTOOTH_ASSERT(std::isfinite(scale) && scale >= 0);
    scale_ = scale;
}

void ContactForce::setOverrides(const ForceOverrides& overrides) {
    TACTOOTH_ASSERT(overrides.stiffness.value_or(0) >= 0);
    TACTOOTH_ASSERT(overrides.damping.value_or(0) >= 0);
    TACTOOTH_ASSERT(overrides.friction.value_or(0) >= 0);
    overrides_ = overrides;
}

void ContactForce::setMaxStiffness(double maxStiffness) {
    TACTOOTH_ASSERT(maxStiffness > 0);
    maxStiffness_ = maxStiffness;
}

/// The properties at this tick: those of the last tick, blended toward those of the material that holds the tool now.
ContactForce::SurfaceProperties ContactForce::blended(const ContactState& contact,
                                                      const SurfaceProperties& target) const {
    TACTOOTH_ASSERT(!(contact.travel < 0));
    TACTOOTH_ASSERT(!(contact.dt < 0));
    const SurfaceProperties old = properties_.value_or(target);
    const double byTravel = 1 - std::exp(-contact.travel / kBlendTravel);
    const double step = std::abs(target.stiffness - old.stiffness) * contact.offset.norm() * scale_;  // N
    const double blend = step > 0 ? std::min(byTravel, kBlendSlew * contact.dt / step) : byTravel;
    TACTOOTH_ASSERT(!(blend < 0 || blend > 1));
    return {old.stiffness + blend * (target.stiffness - old.stiffness),
            old.damping + blend * (target.damping - old.damping),
            old.friction + blend * (target.friction - old.friction)};
}

Wrench ContactForce::at(const ContactState& contact) {
    normalForce_ = stiffness_ = deflection_ = 0;
    const double depth = contact.offset.norm();
    if (contact.held.empty() || !(depth > 0)) {
        properties_.reset();
        friction_.reset();
        return {};
    }
    properties_ = blended(contact, propertiesOf(contact));

    const double stiffness = stiffnessOf(*properties_);
    stiffness_ = scale_ * stiffness;
    TACTOOTH_ASSERT(!(stiffness_ < 0));
    const double damping = overrides_.damping.value_or(properties_->damping);
    const double frictionCoefficient = overrides_.friction.value_or(properties_->friction);

    const Vec3 normal = contact.offset / depth;
    Vec3 moment = Vec3::Zero();  // effect of the force on a rotation, as `normal` is its effect on a displacement
    for (const ContactPoint& held : contact.held) {
        moment += held.multiplier / depth * (held.point - contact.device - contact.offset).cross(held.normal);
    }
    const double approach = -contact.velocity.dot(normal);
    const double penetrationRate = approach - contact.spin.dot(moment);
    const double push = stiffness * depth + damping * penetrationRate;
    normalForce_ = push <= 0 ? 0 : scale_ * push;  // NaN stays NaN, so that the pipeline finds the fault
    const Vec3 friction = friction_.at(contact.device + contact.offset, normal, stiffness_,
                                       frictionCoefficient * normalForce_, contact.rimTravel);
    deflection_ = std::hypot(depth, friction_.deflection().norm());

    Wrench wrench;
    wrench.force = normalForce_ * normal + friction;
    double sum = 0;
    for (const ContactPoint& held : contact.held) sum += held.multiplier;
    TACTOOTH_ASSERT(!(sum < 0));
    for (const ContactPoint& held : contact.held) {
        const Vec3 part =
            held.multiplier / depth * normalForce_ * held.normal + (sum > 0 ? held.multiplier / sum : 0) * friction;
        wrench.torque += (held.point - contact.device - contact.offset).cross(part);
    }
    if (!wrench.force.allFinite() || !wrench.torque.allFinite()) {  // which blend and friction would keep
        properties_.reset();
        friction_.reset();
        normalForce_ = stiffness_ = deflection_ = 0;
    }
    TACTOOTH_ASSERT(normalForce_ >= 0 && std::isfinite(normalForce_));
    TACTOOTH_ASSERT(deflection_ >= 0 && stiffness_ >= 0);
    // The tooth does not pull. False for NaN.
    TACTOOTH_ASSERT(!(wrench.force.dot(normal) < -2 * kUnitLengthTolerance * friction.norm() - 1e-12));
    return wrench;
}

}  // namespace tactooth
