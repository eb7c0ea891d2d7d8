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

/// A place where the tooth holds the proxy.
struct ContactPoint {
    Vec3 point = Vec3::Zero();   ///< mm
    Vec3 normal = Vec3::Zero();  ///< unit, out of the tooth
    double share = 0;            ///< mm; proxy - device = sum of share * normal
    MaterialId material{};
    bool isAdjacent = false;  ///< it is a body around the tooth that holds
};

/// What the force is computed from, all in the tooth's frame.
struct ContactState {
    Vec3 device;        ///< where the hand holds the tool's tip, mm; turned with the proxy, if that turns on its own
    Vec3 offset;        ///< from there to the proxy's tip, mm; its length is the depth
    Vec3 velocity;      ///< of the hand's tip, mm/s
    double travel = 0;  ///< of the proxy since the last tick, mm
    std::span<const ContactPoint> held;
    Vec3 spin = Vec3::Zero();  ///< of the hand, rad/s, if the proxy turns on its own; else zero
    double dt = std::numeric_limits<double>::infinity();  ///< since the last tick, s
    double rimTravel = 0;                                 ///< travel of the turning bur's rim since then, mm
};

/// Instead of the materials' own numbers, for experiments. They hold at once, without a blend.
struct ForceOverrides {
    std::optional<double> stiffness;  ///< N/mm
    std::optional<double> damping;    ///< N*s/mm
    std::optional<double> friction;   ///< Coulomb coefficient; 0: the bare spring and damper
};

/// The force law: a spring and a damper side by side (Kelvin-Voigt) between hand and proxy, which never pull, and dry
/// friction against sliding. Stiffness, damping and friction are those of the material that holds the tool, blended
/// while the tool travels across a border: after 50 um the new material has 95 %, but never faster than by 0.05 N a
/// millisecond. A force that comes out as no number is handed on as it is, for the force pipeline to see, and what
/// was remembered is forgotten with it.
class ContactForce {
public:
    /// `scale` multiplies the whole force.
    void setOverrides(const ForceOverrides& overrides) { overrides_ = overrides; }
    void setScale(double scale) { scale_ = scale; }

    /// The stiffest spring that the device renders without shaking, N/mm. Materials are softened together, so that the
    /// harder one stays the harder one.
    void setMaxStiffness(double stiffest) { maxStiffness_ = stiffest; }

    [[nodiscard]] Wrench at(const ContactState& contact, const MaterialTable& materials);

    /// Length of the force along the proxy's normal at the last call, N.
    [[nodiscard]] double normalForce() const { return normalForce_; }
    /// Of the spring at the last call, N/mm; 0 without contact.
    [[nodiscard]] double stiffness() const { return stiffness_; }
    /// How far the hand has drawn that spring at the last call, inwards and against friction, mm.
    [[nodiscard]] double deflection() const { return deflection_; }

private:
    struct SurfaceProperties {
        double stiffness, damping, friction;
    };
    [[nodiscard]] double stiffnessOf(const SurfaceProperties& feel, const MaterialTable& materials) const;
    [[nodiscard]] static SurfaceProperties propertiesOf(const ContactState& contact, const MaterialTable& materials);

    ForceOverrides overrides_;
    double scale_ = 1;
    double maxStiffness_ = std::numeric_limits<double>::infinity();
    std::optional<SurfaceProperties> properties_;  // none while nothing is touched
    double normalForce_ = 0;
    double stiffness_ = 0;
    double deflection_ = 0;
    DryFriction friction_;
};

}  // namespace tactooth
