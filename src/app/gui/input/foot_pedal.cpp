// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/input/foot_pedal.h"

namespace tactooth {

Expected<void> FootPedal::listen() {
    if (choice_.kind == PedalChoice::Kind::None && !teacher_) {
        joysticks_.reset();
        return {};
    }
    if (joysticks_ != nullptr) return {};
    auto joysticks = SdlJoysticks::shared();
    if (!joysticks) {
        choice_ = {};
        teacher_.reset();
        return Unexpected{joysticks.error()};
    }
    joysticks_ = std::move(*joysticks);
    return {};
}

Expected<void> FootPedal::choose(const PedalChoice& choice) {
    choice_ = choice;
    return listen();
}

Expected<void> FootPedal::teach(bool on) {
    teacher_.reset();
    if (on) teacher_.emplace();
    return listen();
}

double FootPedal::step() {
    if (joysticks_ == nullptr) return 0;
    const std::vector<JoystickState> states = joysticks_->states();
    if (teacher_) {
        if (const auto taught = teacher_->look(states)) {
            choice_ = *taught;
            teacher_.reset();
        }
        return 0;  // the foot shows the pedal, it does not drill
    }
    return pedalOf(choice_, states).value_or(0);
}

}  // namespace tactooth
