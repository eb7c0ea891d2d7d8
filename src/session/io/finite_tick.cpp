// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/finite_tick.h"

#include <cmath>
#include <string>

#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

Expected<void> notFinite(double time, const char* what) {
    return unexpected("at t = " + numberText(time) + " s the " + what +
                      " is not a finite number, so nothing is written; look there in the trajectory, and at the size "
                      "and unit of the surfaces (see 'tactooth info').");
}

}  // namespace

Expected<void> checkFinite(double time, const Tick& tick) {
    if (!tick.wrench.force.allFinite()) return notFinite(time, "force");
    if (!tick.wrench.torque.allFinite()) return notFinite(time, "torque");
    if (!std::isfinite(tick.depth)) return notFinite(time, "depth");
    if (!tick.normal.allFinite()) return notFinite(time, "normal");
    if (!tick.proxy.position.allFinite() || !tick.proxy.rotation.coeffs().allFinite()) return notFinite(time, "proxy");
    if (!tick.hand.position.allFinite() || !tick.hand.rotation.coeffs().allFinite()) return notFinite(time, "hand");
    if (!std::isfinite(tick.speed)) return notFinite(time, "speed");
    if (!std::isfinite(tick.speedRpm)) return notFinite(time, "speed of the bur");
    if (!std::isfinite(tick.cutWork)) return notFinite(time, "work of the bur");
    return {};
}

Expected<void> checkFinite(double time, const Contact& contact) {
    if (!std::isfinite(contact.depth)) return notFinite(time, "depth");
    if (!contact.normal.allFinite()) return notFinite(time, "normal");
    if (!contact.point.allFinite()) return notFinite(time, "point of contact");
    return {};
}

}  // namespace tactooth
