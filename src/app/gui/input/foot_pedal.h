// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/pedal.h"

namespace tactooth {

/// The foot pedal of the window: the one that was chosen, or one that is being taught. Joysticks are read as long as
/// one of both is wanted. Knows no widgets.
class FootPedal {
public:
    /// Fails with a sentence if joysticks cannot be read; then there is none.
    [[nodiscard]] Expected<void> choose(const PedalBinding& choice);
    [[nodiscard]] const PedalBinding& choice() const { return choice_; }
    [[nodiscard]] Expected<void> setCalibrating(bool on);
    [[nodiscard]] bool isCalibrating() const { return calibrator_.has_value(); }

    /// Call at least as often as the picture changes: 0 up .. 1 down. A pedal that is not plugged in is up.
    [[nodiscard]] double step();

private:
    [[nodiscard]] Expected<void> listen();

    PedalBinding choice_;
    std::optional<PedalCalibrator> calibrator_;
    std::shared_ptr<SdlJoysticks> joysticks_;
};

}  // namespace tactooth
