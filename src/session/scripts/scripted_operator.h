// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "devices/base/haptic_device.h"

namespace tactooth {

/// One passage of a lesson: the tip goes to and fro between two places while the hand keeps a force.
struct OperatorPhase {
    double seconds = 1;
    Vec3 from = Vec3::Zero();  ///< sideways place of the tip, mm; z is found by the force
    Vec3 to = Vec3::Zero();
    double strokes = 1;  ///< ways between the two places; 2 = there and back
    double force = 0;    ///< N, downwards (-z); 0 = the hand lifts off and waits
    double pedal = 0;
    bool cutting = false;
};

/// A hand that knows what it wants to feel: it pushes down until the force that comes back is the one it aims at, as a
/// dentist does, and so finds the surface of any tooth and follows it while it is cut away.
class ScriptedOperator final : public HapticDevice {
public:
    /// `start`: where the tip waits, above the tooth; `grip`: how the tool is held all the time. The script is not
    /// empty.
    ScriptedOperator(const Vec3& start, const Quat& grip, std::vector<OperatorPhase> script);

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override { force_ = wrench.force(); }

    /// The passage that the hand is in.
    [[nodiscard]] const OperatorPhase& phase() const { return script_[phase_]; }
    [[nodiscard]] std::size_t phaseIndex() const { return phase_; }
    [[nodiscard]] bool finished() const { return finished_; }

private:
    DeviceInfo info_;
    std::vector<OperatorPhase> script_;
    double waitingHeight_;
    std::size_t phase_ = 0;
    double time_ = 0;  // in the passage, s
    bool finished_ = false;
    Vec3 tip_;
    Quat grip_;
    Vec3 force_ = Vec3::Zero();
};

}  // namespace tactooth
