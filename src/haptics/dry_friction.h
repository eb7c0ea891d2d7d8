// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/vec.h"

namespace tactooth {

/// Dry (Coulomb) friction by the deflection of a bristle, without the speed. The tip of the proxy is tied to an anchor
/// on the tooth by a spring (the bristle). When the force of the spring exceeds the largest friction, the anchor
/// follows the tip. So a hand at rest is held where it came to rest, a single step of an encoder changes the force by a
/// little and gives no pulse, and no more energy comes out than the hand has put in. The proxy slides, not the device:
/// where a groove holds the proxy, there is no friction.
class DryFriction {
public:
    /// One tick in contact. Returns the force on the hand, N, across the normal, in the tooth's frame.
    /// `proxy`: position of the proxy's tip, mm; `normal`: unit; `stiffness`: of the bristle, N/mm; `maxFriction`: the
    /// largest friction, N; `rimTravel`: travel of a turning bur's rim since the last tick, mm, which relaxes the
    /// bristle. None of the numbers is negative.
    [[nodiscard]] Vec3 at(const Vec3& proxy, const Vec3& normal, double stiffness, double maxFriction,
                          double rimTravel);

    /// Removes the anchor. Call it at a tick without contact.
    void reset();

    /// From the anchor to the proxy's tip, across the normal, at the last call, mm.
    [[nodiscard]] const Vec3& deflection() const { return deflection_; }

private:
    std::optional<Vec3> last_;
    Vec3 deflection_ = Vec3::Zero();
};

}  // namespace tactooth
