// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// How warm a device's motors are: 0 cold, 1 as warm as the force that they bear for ever makes them. A motor's heat is
/// that of its current, which goes with the force: the square of the force, low-passed.
class MotorThermalModel {
public:
    /// `peak` and `continuous`: what the device may be asked for at once and for ever, N.
    MotorThermalModel(double peak, double continuous) : peak_(peak), continuous_(continuous) {}

    /// `force` N was rendered for `elapsed` s. `reported`: what the device says of itself, 0..1; 0 if it says nothing.
    /// False if one of them is no number: the motors then count as warm, and cool from there.
    bool add(double force, double elapsed, double reported);

    /// The most that may be rendered now, N: the peak while cold, the continuous force when warm, never below that.
    [[nodiscard]] double bound() const;
    [[nodiscard]] double heat() const { return heat_; }

private:
    double peak_;
    double continuous_;
    double modelled_ = 0;
    double heat_ = 0;  // the worse of model and report
};

}  // namespace tactooth
