// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/tip/tip_hold.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

// Clinical texts describe the sign, a tug when the explorer is withdrawn from softened dentin, but give no figures. The
// law is chosen: the tip sinks in like a body into a viscous one, exponentially, and what holds it is friction on its
// sides, in proportion to the force that pressed it in.

namespace tactooth {
namespace {

constexpr double kFirm = 0.5;      // N/mm: decay that is as stiff is leathery and gives no hold (Knoop 25-50)
constexpr double kGrip = 4;        // of the pressing force, times the softness
constexpr double kMostGrip = 1;    // N: more would lift the jaw
constexpr double kSinking = 0.15;  // s until the tip is in to 1/e

}  // namespace

double softness(const MaterialTable& materials, MaterialId tissue) {
    if (!materials.registry().hasRole(tissue, MaterialRole::Decay)) return 0;
    return std::clamp(1 - materials[tissue].stiffness / kFirm, 0.0, 1.0);
}

void TipHold::touch(const Touch& touch, double dt) {
    TACTOOTH_ASSERT(!(dt < 0));
    TACTOOTH_ASSERT(!(touch.force < 0) && touch.softness >= 0 && touch.softness <= 1);
    if (!place_) {
        if (!(touch.softness > 0) || !touch.tip.allFinite()) return;
        TACTOOTH_ASSERT(isUnit(touch.normal));
        place_ = touch.tip;
        outward_ = touch.normal;
    }
    stiffness_ = touch.stiffness;
    const double pressed = touch.force * std::max(0.0, touch.normal.dot(outward_));
    const double goal = std::min(kMostGrip, kGrip * touch.softness * pressed);
    if (goal > force_) force_ += (goal - force_) * (1 - std::exp(-dt / kSinking));
    TACTOOTH_ASSERT(force_ >= 0 && force_ <= kMostGrip);
}

void TipHold::release() {
    place_.reset();
    force_ = 0;
}

std::optional<Vec3> TipHold::placeFor(const Vec3& device) {
    if (!place_) return std::nullopt;
    Vec3 pull = device - *place_;
    pull -= std::min(0.0, pull.dot(outward_)) * outward_;  // what presses it in does not draw it out
    if (stiffness_ * pull.norm() <= force_) return place_;
    release();
    return std::nullopt;
}

}  // namespace tactooth
