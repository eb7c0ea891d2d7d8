// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <span>
#include <stop_token>

#include "session/kernel/stepwise_session.h"
#include "session/scripts/trajectory.h"

namespace tactooth {

/// Times `work` and writes the duration, us, to `micros`.
template <class Work>
auto timed(double& micros, Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    micros = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    return result;
}

/// One haptic run along a trajectory with its time steps, in touch mode with a spindle at rest. Calls `visit(time,
/// tick)` for each row. Fails with one sentence at the first tick that is not finite (see checkFinite). Ends early when
/// `stop` asks for it.
[[nodiscard]] Expected<void> runTouchPath(std::span<const TimedPose> trajectory, StepwiseSession& session,
                                          const std::function<void(double, const Tick&)>& visit,
                                          const std::stop_token& stop = {});

}  // namespace tactooth
