// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/vec.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// How far a tissue gives way to the edge or the tip of an instrument in the hand: 0 for what only a drive can cut, up
/// to 1. Only decay is soft, the more the lower its stiffness is, which stands for its hardness in the table of
/// materials.
[[nodiscard]] double softness(const MaterialTable& materials, MaterialId tissue);

/// The fine tip of an explorer in soft decay: it sinks in as long as it is pressed, and then a force is needed to draw
/// it out or aside. The harder it was pressed, the larger that force is. On sound tissue the tip slides.
class TipHold {
public:
    /// The tip in contact with tissue, in the tooth's frame.
    struct Touch {
        Vec3 tip = Vec3::Zero();     ///< of the proxy, mm
        Vec3 normal = Vec3::Zero();  ///< unit, from the device to the proxy
        double force = 0;            ///< along it, N
        double stiffness = 0;        ///< of the contact spring, N/mm
        double softness = 0;         ///< of the tissue, 0..1
    };
    /// A tick of `dt` s in contact.
    void touch(const Touch& touch, double dt);
    /// A tick without contact, or without a pose.
    void release();

    /// Where the tip is held while the hand has its own tip at `device`; none: nothing holds it, or it has just come
    /// free.
    [[nodiscard]] std::optional<Vec3> placeFor(const Vec3& device);
    /// The force that draws the tip out, N; 0 if nothing holds it.
    [[nodiscard]] double force() const { return force_; }

private:
    std::optional<Vec3> place_;
    Vec3 outward_ = Vec3::Zero();  // unit, when the tip went in
    double stiffness_ = 0;
    double force_ = 0;
};

}  // namespace tactooth
