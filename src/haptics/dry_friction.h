// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/vec.h"

namespace tactooth {

/// Dry friction (Coulomb) that needs no speed: the tool clings to a place on the tooth until it is drawn further than
/// friction holds, and then drags that place along. A hand at rest is held as it came to rest; the single step of an
/// encoder gives a small, lasting change and not a pulse; and no more energy comes out than the hand has put in. It is
/// the proxy that clings: where a groove holds it, it does not slide, and friction has nothing to do.
class DryFriction {
public:
    /// One tick in contact; gives the force on the hand, N, across the normal. `proxy`: where its tip is, mm; `normal`:
    /// unit; `stiffness` N/mm: with which it clings; `most` N: what it holds; `rimTravel` mm: travel of a turning bur's
    /// rim since the last tick, which tears the tool off whatever it clings to.
    [[nodiscard]] Vec3 at(const Vec3& proxy, const Vec3& normal, double stiffness, double most, double rimTravel);

    /// Forgets the place; for a tick without contact.
    void reset();

    /// From the place to the proxy, across the normal, at the last call, mm.
    [[nodiscard]] const Vec3& deflection() const { return deflection_; }

private:
    std::optional<Vec3> last_;
    Vec3 deflection_ = Vec3::Zero();
};

}  // namespace tactooth
