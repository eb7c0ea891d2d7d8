// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/tick_input.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"

// A grid that is a power of two makes every number of it exact in binary. The size of a recording follows from it: 4.6
// bytes a tick with steps of 2^-12 mm and 2^-24 (docs/session-file.md).

namespace tactooth {
namespace {

constexpr double kMaxDistance = 1e6;  // mm, as in HapticSimulation: a pose beyond is a fault of the device
constexpr double kMaxElapsed = 900;   // s

[[nodiscard]] bool isOnGrid(const Pose& pose) {
    return pose.position.allFinite() && pose.rotation.coeffs().allFinite() &&
           pose.position.cwiseAbs().maxCoeff() < kMaxDistance && pose.rotation.coeffs().cwiseAbs().maxCoeff() < 2;
}

}  // namespace

TickInput TickInput::of(const OperatorInput& input, double elapsed) {
    TickInput result;
    result.cutting = input.cutting;
    if (std::isfinite(input.pedal)) {
        result.pedal = static_cast<std::int32_t>(std::lround(std::clamp(input.pedal, 0.0, 1.0) / kPedalStep));
    }
    if (elapsed > 0 && elapsed < kMaxElapsed)
        result.elapsed = static_cast<std::int32_t>(std::lround(elapsed / kTimeStep));
    result.hasPose = isOnGrid(input.deviceInTooth);
    if (!result.hasPose) return result;
    for (int axis = 0; axis < 3; ++axis) {
        result.position[static_cast<std::size_t>(axis)] =
            std::llround(input.deviceInTooth.position[axis] / kPositionStep);
    }
    for (int i = 0; i < 4; ++i) {
        result.rotation[static_cast<std::size_t>(i)] =
            static_cast<std::int32_t>(std::lround(input.deviceInTooth.rotation.coeffs()[i] / kRotationStep));
    }
    return result;
}

OperatorInput TickInput::operatorInput() const {
    OperatorInput input;
    input.cutting = cutting;
    input.pedal = kPedalStep * pedal;
    if (!hasPose) {
        input.deviceInTooth.position.setConstant(std::numeric_limits<double>::quiet_NaN());
        return input;
    }
    for (int axis = 0; axis < 3; ++axis) {
        input.deviceInTooth.position[axis] =
            kPositionStep * static_cast<double>(position[static_cast<std::size_t>(axis)]);
    }
    for (int i = 0; i < 4; ++i) {
        input.deviceInTooth.rotation.coeffs()[i] = kRotationStep * rotation[static_cast<std::size_t>(i)];
    }
    return input;
}

double ElapsedTime::next(double elapsed) {
    if (!std::isfinite(elapsed)) return elapsed;
    const double wanted = rest_ + elapsed;
    const double used = std::max(0.0, std::round(wanted / TickInput::kTimeStep) * TickInput::kTimeStep);
    rest_ = std::clamp(wanted - used, -TickInput::kTimeStep, TickInput::kTimeStep);
    TACTOOTH_ASSERT(used >= 0);
    return used;
}

}  // namespace tactooth
