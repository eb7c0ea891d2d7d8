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
        kept.position[i] = tick.proxy.position[axis];
        kept.force[i] = tick.wrench.force[axis];
    }
    for (std::size_t i = 0; i < 4; ++i) kept.rotation[i] = tick.proxy.rotation.coeffs()[static_cast<Eigen::Index>(i)];
    kept.depth = tick.depth;
    kept.speedRpm = tick.speedRpm;
    kept.speed = static_cast<float>(tick.speed);
    kept.pedal = static_cast<float>(tick.pedal);
    kept.load = static_cast<float>(tick.load);
    kept.removalPower = static_cast<float>(tick.removalPower);
    kept.impactSpeed = static_cast<float>(tick.impactSpeed);
    kept.contactOnsets = tick.contactOnsets;
    constexpr int kMost = std::numeric_limits<std::uint16_t>::max();
    kept.contacts = static_cast<std::uint16_t>(std::clamp(tick.contacts, 0, kMost));
    kept.material = static_cast<std::uint8_t>(tick.material);
    kept.cutting = tick.cutting;
    kept.placed = tick.placed;
    return kept;
}

Tick TrackTick::tick() const {
    Tick tick;
    tick.time = time;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        tick.proxy.position[axis] = position[i];
        tick.wrench.force[axis] = force[i];
    }
    for (std::size_t i = 0; i < 4; ++i) tick.proxy.rotation.coeffs()[static_cast<Eigen::Index>(i)] = rotation[i];
    tick.hand = tick.proxy;
    tick.depth = depth;
    tick.speedRpm = speedRpm;
    tick.speed = static_cast<double>(speed);
    tick.pedal = static_cast<double>(pedal);
    tick.load = static_cast<double>(load);
    tick.removalPower = static_cast<double>(removalPower);
    tick.impactSpeed = static_cast<double>(impactSpeed);
    tick.contactOnsets = contactOnsets;
    tick.contacts = contacts;
    tick.material = static_cast<MaterialId>(material);
    tick.cutting = cutting;
    tick.placed = placed;
    return tick;
}

}  // namespace tactooth
