// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "devices/base/haptic_device.h"

namespace tactooth {

/// One phase of a script: the tip moves to and fro between two positions while the hand keeps a force.
struct OperatorPhase {
    double seconds = 1;
    Vec3 from = Vec3::Zero();  ///< lateral position of the tip, mm; the force determines z
    Vec3 to = Vec3::Zero();
    double strokes = 1;  ///< passes between the two positions; 2 = there and back
    double force = 0;    ///< N, downwards (-z); 0 = the hand lifts off and waits
    double pedal = 0;
    bool cutting = false;
};

/// A simulated hand that controls its force: it pushes down until the force of the device is the target force. So it
/// finds the surface of any tooth and follows it during a cut.
class ScriptedOperator final : public HapticDevice {
public:
    /// `start`: position of the tip above the tooth at first; `grip`: orientation of the tool. The script is not empty.
    ScriptedOperator(const Vec3& start, const Quat& grip, std::vector<OperatorPhase> script);

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override { force_ = wrench.force(); }

    /// The present phase.
    [[nodiscard]] const OperatorPhase& phase() const { return script_[phase_]; }
    [[nodiscard]] std::size_t phaseIndex() const { return phase_; }
    [[nodiscard]] bool finished() const { return finished_; }

private:
    DeviceInfo info_;
    std::vector<OperatorPhase> script_;
    double waitingHeight_;
    std::size_t phase_ = 0;
    double time_ = 0;  // in the phase, s
    bool finished_ = false;
    Vec3 tip_;
    Quat grip_;
    Vec3 force_ = Vec3::Zero();
};

}  // namespace tactooth
