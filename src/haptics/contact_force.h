// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "geometry/util/pose.h"
#include "haptics/dry_friction.h"
#include "haptics/wrench.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// A point where the tooth holds the proxy, in the tooth's frame.
struct ContactPoint {
    Vec3 point = Vec3::Zero();   ///< mm
    Vec3 normal = Vec3::Zero();  ///< unit, out of the tooth
    double multiplier = 0;       ///< mm, not negative; proxy - device = sum of multiplier * normal
    MaterialId material{};
    bool isAdjacent = false;  ///< a body of the surroundings holds the proxy
};

/// Input of the force law, all in the tooth's frame.
struct ContactState {
    Vec3 device;        ///< position of the device's tip, mm; rotated with the proxy, if the proxy rotates on its own
    Vec3 offset;        ///< from there to the proxy's tip, mm; its length is the depth
    Vec3 velocity;      ///< of the device's tip, mm/s
    double travel = 0;  ///< of the proxy since the last tick, mm
    std::span<const ContactPoint> held;
    Vec3 spin = Vec3::Zero();  ///< angular velocity of the device, rad/s, if the proxy rotates on its own; else zero
    double dt = std::numeric_limits<double>::infinity();  ///< time since the last tick, s
    double rimTravel = 0;                                 ///< travel of the turning bur's rim since then, mm
};

/// Replaces numbers of all materials, for experiments. They hold at once, without a blend. None is negative.
struct ForceOverrides {
    std::optional<double> stiffness{};  ///< N/mm
    std::optional<double> damping{};    ///< N*s/mm
    std::optional<double> friction{};   ///< Coulomb coefficient; 0: only spring and damper

    friend bool operator==(const ForceOverrides&, const ForceOverrides&) = default;
};

/// The force law: a spring and a damper in parallel (Kelvin-Voigt) between device and proxy, which never pull, and dry
/// friction against sliding. Stiffness, damping and friction are those of the material that holds the tool. They blend
/// while the tool travels across a border: after 50 um the new material has 95 %, but the force never changes by more
/// than 0.05 N in a millisecond. A force that is not finite is returned as it is, so that the force pipeline finds the
/// fault. The memory of the law is then reset.
class ContactForce {
public:
    explicit ContactForce(const MaterialTable& materials = MaterialTable());

    /// `scale` multiplies the whole force; finite and not negative.
    void setScale(double scale);
    void setOverrides(const ForceOverrides& overrides);

    /// The largest stiffness that the device renders without oscillation, N/mm, positive. All materials are softened
    /// together, so that the harder of two stays the harder one.
    void setMaxStiffness(double maxStiffness);

    /// The force of a tick, N, and its torque about the proxy's tip, N*mm, in the tooth's frame.
    [[nodiscard]] Wrench at(const ContactState& contact);

    /// Force along the normal of the proxy at the last call, N; not negative.
    [[nodiscard]] double normalForce() const { return normalForce_; }
    /// Stiffness of the spring at the last call, N/mm; 0 without contact.
    [[nodiscard]] double stiffness() const { return stiffness_; }
    /// Deflection of that spring at the last call, inwards and against friction, mm.
    [[nodiscard]] double deflection() const { return deflection_; }

private:
    struct SurfaceProperties {
        double stiffness, damping, friction;
    };
    [[nodiscard]] double stiffnessOf(const SurfaceProperties& properties) const;
    [[nodiscard]] SurfaceProperties blended(const ContactState& contact, const SurfaceProperties& target) const;
    [[nodiscard]] SurfaceProperties propertiesOf(const ContactState& contact) const;

    MaterialTable materials_;
    double hardest_ = 0;  // largest stiffness of a material, N/mm
    ForceOverrides overrides_;
    double scale_ = 1;
    double maxStiffness_ = std::numeric_limits<double>::infinity();
    std::optional<SurfaceProperties> properties_;  // none without contact
    double normalForce_ = 0;
    double stiffness_ = 0;
    double deflection_ = 0;
    DryFriction friction_;
};

}  // namespace tactooth
