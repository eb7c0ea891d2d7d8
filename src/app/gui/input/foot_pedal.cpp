// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/input/foot_pedal.h"

namespace tactooth {

Expected<void> FootPedal::listen() {
    if (choice_.kind == PedalBinding::Kind::None && !calibrator_) {
        joysticks_.reset();
        return {};
    }
    if (joysticks_ != nullptr) return {};
    auto joysticks = SdlJoysticks::shared();
    if (!joysticks) {
        choice_ = {};
        calibrator_.reset();
        return Unexpected{joysticks.error()};
    }
    joysticks_ = std::move(*joysticks);
    return {};
}

Expected<void> FootPedal::choose(const PedalBinding& choice) {
    choice_ = choice;
    return listen();
}

Expected<void> FootPedal::setCalibrating(bool on) {
    calibrator_.reset();
    if (on) calibrator_.emplace();
    return listen();
}

double FootPedal::step() {
    if (joysticks_ == nullptr) return 0;
    const std::vector<JoystickState> states = joysticks_->states();
    if (calibrator_) {
        if (const auto taught = calibrator_->update(states)) {
            choice_ = *taught;
            calibrator_.reset();
        }
        return 0;  // calibration does not drill
    }
    return pedalOf(choice_, states).value_or(0);
}

}  // namespace tactooth
