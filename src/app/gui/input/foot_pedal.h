// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/sdl/pedal.h"

namespace tactooth {

/// The foot pedal: the chosen one, or one that is being calibrated. Joysticks are read only while one of them needs it.
class FootPedal {
public:
    /// Fails with a sentence if joysticks cannot be read; then there is no pedal.
    [[nodiscard]] Expected<void> choose(const PedalBinding& choice);
    [[nodiscard]] const PedalBinding& choice() const { return choice_; }
    [[nodiscard]] Expected<void> setCalibrating(bool on);
    [[nodiscard]] bool isCalibrating() const { return calibrator_.has_value(); }

    /// Returns the position, 0 up .. 1 down; a pedal that is not plugged in is up. Call it at least as often as the
    /// picture changes.
    [[nodiscard]] double step();

private:
    [[nodiscard]] Expected<void> listen();

    PedalBinding choice_;
    std::optional<PedalCalibrator> calibrator_;
    std::shared_ptr<SdlJoysticks> joysticks_;
};

}  // namespace tactooth
