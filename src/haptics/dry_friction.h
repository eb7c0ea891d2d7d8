// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/vec.h"

namespace tactooth {

/// Dry (Coulomb) friction without a speed. The tool sticks to a point of the tooth like a bristle. When the tool is
/// farther from it than friction holds, it drags the point along. So a hand at rest is held where it came to rest. A
/// single encoder step gives a small lasting change of force and not a pulse, and no more energy comes out than the
/// hand has put in. The proxy sticks, not the device: where a groove holds the proxy, it does not slide, and there is
/// no friction.
class DryFriction {
public:
    /// One tick in contact. Returns the force on the hand, N, across the normal.
    /// `proxy`: position of the proxy's tip, mm; `normal`: unit; `stiffness`: of the bristle, N/mm; `maxFriction`: the
    /// largest friction, N; `rimTravel`: travel of a turning bur's rim since the last tick, mm, which tears the tool
    /// off. None of the numbers is negative.
    [[nodiscard]] Vec3 at(const Vec3& proxy, const Vec3& normal, double stiffness, double maxFriction,
                          double rimTravel);

    /// Forgets the point. Call it at a tick without contact.
    void reset();

    /// From the point to the proxy, across the normal, at the last call, mm.
    [[nodiscard]] const Vec3& deflection() const { return deflection_; }

private:
    std::optional<Vec3> last_;
    Vec3 deflection_ = Vec3::Zero();
};

}  // namespace tactooth
