// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/finite_tick.h"

#include <cmath>
#include <string>

#include "geometry/util/number_text.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

Expected<void> notFinite(double time, const MessageText& what) {
    return unexpected(msg::kTickNotFinite, numberText(time), what);
}

}  // namespace

Expected<void> checkFinite(double time, const Tick& tick) {
    if (!tick.force.wrench.force.allFinite()) return notFinite(time, msg::kTickForce);
    if (!tick.force.wrench.torque.allFinite()) return notFinite(time, msg::kTickTorque);
    if (!std::isfinite(tick.contact.depth)) return notFinite(time, msg::kTickDepth);
    if (!tick.contact.normal.allFinite()) return notFinite(time, msg::kTickNormal);
    if (!tick.contact.proxy.position.allFinite() || !tick.contact.proxy.rotation.coeffs().allFinite())
        return notFinite(time, msg::kTickProxy);
    if (!tick.input.device.position.allFinite() || !tick.input.device.rotation.coeffs().allFinite())
        return notFinite(time, msg::kTickHand);
    if (!std::isfinite(tick.input.speed)) return notFinite(time, msg::kTickSpeed);
    if (!std::isfinite(tick.spindle.speedRpm)) return notFinite(time, msg::kTickBurSpeed);
    if (!std::isfinite(tick.spindle.cutWork)) return notFinite(time, msg::kTickBurWork);
    return {};
}

Expected<void> checkFinite(double time, const Contact& contact) {
    if (!std::isfinite(contact.depth)) return notFinite(time, msg::kTickDepth);
    if (!contact.normal.allFinite()) return notFinite(time, msg::kTickNormal);
    if (!contact.point.allFinite()) return notFinite(time, msg::kTickContactPoint);
    return {};
}

}  // namespace tactooth
