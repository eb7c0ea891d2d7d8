// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/servo_stage.h"

#include <bit>
#include <utility>

namespace tactooth {

ServoStage::ServoStage(const Instrument& instrument, std::shared_ptr<const Surface> surface,
                       const HapticSettings& settings, Placement placement)
    : simulation_(instrument.shape, instrument.cutting.envelope.maxRadius(), std::move(surface), settings) {
    if (instrument.hand) simulation_.holdByHand(*instrument.hand, settings.materials);
    if (placement == Placement::Deferred) simulation_.deferPlacement();
}

void ServoStage::setForce(const ForceParameters& parameters) {
    simulation_.force().setOverrides(parameters.overrides);
    simulation_.force().setScale(parameters.scale);
    simulation_.force().setMaxStiffness(parameters.maxStiffness);
}

Tick ServoStage::step(const OperatorInput& input, double elapsed) {
    Tick tick = simulation_.step(input, elapsed);
    tick.number = ++ticks_;
    addToHash(hash_, tick);
    return tick;
}

/// Words, not bytes: this runs at every tick.
void addToHash(Fnv1a& hash, const Tick& tick) {
    const auto add = [&hash](double value) { hash.addWord(std::bit_cast<std::uint64_t>(value)); };
    for (int axis = 0; axis < 3; ++axis) {
        add(tick.contact.proxy.position[axis]);
        add(tick.force.wrench.force[axis]);
        add(tick.force.wrench.torque[axis]);
    }
    for (int i = 0; i < 4; ++i) add(tick.contact.proxy.rotation.coeffs()[i]);
    add(tick.contact.depth);
    add(tick.spindle.speedRpm);
    add(tick.spindle.cutWork);
    hash.addWord(static_cast<std::uint64_t>(tick.contact.triangles) << 1 | (tick.contact.placed ? 1 : 0));
}

}  // namespace tactooth
