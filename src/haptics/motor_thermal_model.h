// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// The temperature of a device's motors: 0 is cold, and 1 is the temperature that the continuous force leads to. The
/// heat of a motor is that of its current, and the current is proportional to the force. So the model is the square of
/// the force, low-passed (an i²t limit).
class MotorThermalModel {
public:
    /// `peak` is the largest force of the device, N, finite. `continuous` is the force that it can render without end,
    /// N, positive; infinite if it has no such limit.
    MotorThermalModel(double peak, double continuous);

    /// `force` N was rendered for `elapsed` s. `reported` is the temperature that the device reports, 0..1, or 0 if it
    /// reports none. Returns false if one of them is not finite: the motors then count as warm, and cool from there.
    bool add(double force, double elapsed, double reported);

    /// The largest force that may be rendered now, N: the peak force while the motors are cold, the continuous force
    /// when they are warm, never less.
    [[nodiscard]] double bound() const;
    [[nodiscard]] double heat() const { return heat_; }

private:
    double peak_;
    double continuous_;
    double modelled_ = 0;
    double heat_ = 0;  // the larger of model and report
};

}  // namespace tactooth
