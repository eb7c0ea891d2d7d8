// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/track_tick.h"

#include <algorithm>
#include <limits>

namespace tactooth {

TrackTick TrackTick::of(double time, const Tick& tick) {
    TrackTick kept;
    kept.time = time;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        kept.position[i] = tick.contact.proxy.position[axis];
        kept.force[i] = tick.force.wrench.force[axis];
    }
    for (std::size_t i = 0; i < 4; ++i)
        kept.rotation[i] = tick.contact.proxy.rotation.coeffs()[static_cast<Eigen::Index>(i)];
    kept.depth = tick.contact.depth;
    kept.speedRpm = tick.spindle.speedRpm;
    kept.speed = static_cast<float>(tick.input.speed);
    kept.pedal = static_cast<float>(tick.input.pedal);
    kept.load = static_cast<float>(tick.spindle.load);
    kept.removalPower = static_cast<float>(tick.spindle.removalPower);
    kept.impactSpeed = static_cast<float>(tick.contact.impactSpeed);
    kept.slideSpeed = static_cast<float>(tick.contact.slideSpeed);
    kept.pullOutForce = static_cast<float>(tick.contact.pullOutForce);
    kept.contactOnsets = tick.contact.onsets;
    kept.pullOuts = tick.contact.pullOuts;
    constexpr int kMost = std::numeric_limits<std::uint16_t>::max();
    kept.contacts = static_cast<std::uint16_t>(std::clamp(tick.contact.triangles, 0, kMost));
    kept.material = static_cast<std::uint8_t>(tick.contact.material);
    kept.cutting = tick.input.cutting;
    kept.placed = tick.contact.placed;
    return kept;
}

Tick TrackTick::tick() const {
    Tick tick;
    tick.time = time;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        tick.contact.proxy.position[axis] = position[i];
        tick.force.wrench.force[axis] = force[i];
    }
    for (std::size_t i = 0; i < 4; ++i)
        tick.contact.proxy.rotation.coeffs()[static_cast<Eigen::Index>(i)] = rotation[i];
    tick.input.device = tick.contact.proxy;
    tick.contact.depth = depth;
    tick.spindle.speedRpm = speedRpm;
    tick.input.speed = static_cast<double>(speed);
    tick.input.pedal = static_cast<double>(pedal);
    tick.spindle.load = static_cast<double>(load);
    tick.spindle.removalPower = static_cast<double>(removalPower);
    tick.contact.impactSpeed = static_cast<double>(impactSpeed);
    tick.contact.slideSpeed = static_cast<double>(slideSpeed);
    tick.contact.pullOutForce = static_cast<double>(pullOutForce);
    tick.contact.onsets = contactOnsets;
    tick.contact.pullOuts = pullOuts;
    tick.contact.triangles = contacts;
    tick.contact.material = static_cast<MaterialId>(material);
    tick.input.cutting = cutting;
    tick.contact.placed = placed;
    return tick;
}

}  // namespace tactooth
