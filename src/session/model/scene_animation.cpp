// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/scene_animation.h"

#include <cmath>
#include <numbers>

namespace tactooth {

void SceneAnimation::advance(const Tick& tick, bool water, bool suction, const MaterialVolumes& ground, double dt) {
    spin_ = std::remainder(spin_ + tick.spindle.speedRpm / 60 * 2 * std::numbers::pi * dt, 2 * std::numbers::pi);
    const SprayInput now{.toolInTooth = tick.contact.proxy,
                         .normal = tick.contact.normal,
                         .speedRpm = tick.spindle.speedRpm,
                         .water = water && tick.input.cutting ? tick.input.pedal : 0,
                         .suction = suction,
                         .ground = ground};
    spray_.advance(now, dt);
    liquids_.advance(now, pulp_.place(), dt);
}

}  // namespace tactooth
