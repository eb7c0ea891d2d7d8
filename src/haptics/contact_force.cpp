// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/contact_force.h"

#include <algorithm>
#include <cmath>

// Kelvin-Voigt contact: W. Fluegge, "Viscoelasticity", 1975, section 1.3: F = k * d + c * d'. Friction clings with the
// same spring, so that a proxy held by friction pulls straight from the hand to where it stays.

namespace tactooth {
namespace {

// Travel in which what is left of the old material's feel falls to 1/e, mm: to 5 % within 50 um. An exponential,
// because it blends by the way alone: the same for one long tick as for many short ones.
constexpr double kBlendTravel = 0.05 / 3;
// A hand that crosses a border fast, or deep, shall not feel a step: N/s that the blend may change the force by, half
// of what a hand just feels at 10 Hz and more (0.03 to 0.05 N) a millisecond.
constexpr double kBlendSlew = 50;

}  // namespace

ContactForce::SurfaceProperties ContactForce::propertiesOf(const ContactState& contact,
                                                           const MaterialTable& materials) {
    SurfaceProperties feel{0, 0, 0};
    double weight = 0;
    for (const ContactPoint& held : contact.held) {
        const Material& material = materials[held.material];
        const double share = std::max(held.share, 1e-12);  // a contact that just touches still has a material
        feel.stiffness += share * material.stiffness;
        feel.damping += share * material.damping;
        feel.friction += share * material.friction;
        weight += share;
    }
    return {feel.stiffness / weight, feel.damping / weight, feel.friction / weight};
}

/// The spring that is rendered, before `scale_`.
double ContactForce::stiffnessOf(const SurfaceProperties& feel, const MaterialTable& materials) const {
    if (!std::isfinite(maxStiffness_)) return overrides_.stiffness.value_or(feel.stiffness);
    double hardest = 0;
    for (const MaterialId id : materials.registry().ids()) hardest = std::max(hardest, materials[id].stiffness);
    const double softened = hardest > maxStiffness_ ? feel.stiffness * maxStiffness_ / hardest : feel.stiffness;
    const double spring = overrides_.stiffness.value_or(softened);
    return scale_ > 0 ? std::min(spring, maxStiffness_ / scale_) : spring;
}

Wrench ContactForce::at(const ContactState& contact, const MaterialTable& materials) {
    normalForce_ = stiffness_ = deflection_ = 0;
    const double depth = contact.offset.norm();
    if (contact.held.empty() || !(depth > 0)) {
        properties_.reset();
        friction_.reset();
        return {};
    }
    const SurfaceProperties target = propertiesOf(contact, materials);
    const SurfaceProperties old = properties_.value_or(target);
    const double byTravel = 1 - std::exp(-contact.travel / kBlendTravel);
    const double step = std::abs(target.stiffness - old.stiffness) * depth * scale_;  // N, of the whole blend
    const double blend = step > 0 ? std::min(byTravel, kBlendSlew * contact.dt / step) : byTravel;
    properties_ = SurfaceProperties{old.stiffness + blend * (target.stiffness - old.stiffness),
                                    old.damping + blend * (target.damping - old.damping),
                                    old.friction + blend * (target.friction - old.friction)};

    const double stiffness = stiffnessOf(*properties_, materials);
    stiffness_ = scale_ * stiffness;
    const double damping = overrides_.damping.value_or(properties_->damping);
    const double frictionCoefficient = overrides_.friction.value_or(properties_->friction);

    const Vec3 normal = contact.offset / depth;
    Vec3 moment = Vec3::Zero();  // what the push does to a turn, as `normal` is what it does to a shift
    for (const ContactPoint& held : contact.held) {
        moment += held.share / depth * (held.point - contact.device - contact.offset).cross(held.normal);
    }
    const double approach = -contact.velocity.dot(normal);
    const double penetrationRate = approach - contact.spin.dot(moment);
    const double push = stiffness * depth + damping * penetrationRate;
    normalForce_ = push <= 0 ? 0 : scale_ * push;  // what is no number stays none, so that it is seen
    const Vec3 friction = friction_.at(contact.device + contact.offset, normal, stiffness_,
                                       frictionCoefficient * normalForce_, contact.rimTravel);
    deflection_ = std::hypot(depth, friction_.deflection().norm());

    Wrench wrench;
    wrench.force = normalForce_ * normal + friction;
    double shares = 0;
    for (const ContactPoint& held : contact.held) shares += held.share;
    for (const ContactPoint& held : contact.held) {
        const Vec3 part =
            held.share / depth * normalForce_ * held.normal + (shares > 0 ? held.share / shares : 0) * friction;
        wrench.torque += (held.point - contact.device - contact.offset).cross(part);
    }
    if (!wrench.force.allFinite() || !wrench.torque.allFinite()) {  // which the blend and the friction would keep
        properties_.reset();
        friction_.reset();
        normalForce_ = stiffness_ = deflection_ = 0;
    }
    return wrench;
}

}  // namespace tactooth
