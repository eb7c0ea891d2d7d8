// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>

#include "bench_scene.h"
#include "session/recording/session_recorder.h"
#include "session/scripts/touch_run.h"

namespace tactooth::test {

/// A clock that shows one millisecond for each tick.
inline std::chrono::steady_clock::time_point atTick(int ticks) {
    return std::chrono::steady_clock::time_point(std::chrono::milliseconds(ticks));
}

/// Records 1500 ticks of a bur that slides over the block, 1.5 s. `note` is called before the first tick and then after
/// each one with their number. Returns CutModel::hash at the end.
inline std::uint64_t recordTouches(const std::filesystem::path& file,
                                   const std::function<void(SessionRecorder&, int)>& note) {
    std::vector<TimedPose> path;
    for (int i = 0; i < 1500; ++i) path.push_back({0.001 * i, at(0.5 * std::sin(0.01 * i), 0, 0.1)});
    const auto model = blockOnTheBench();
    auto recorder = SessionRecorder::create(file, *model, "block");
    EXPECT_TRUE(recorder);
    StepwiseSession session(model, {touchingTool(flatBur().shape), HapticSettings(), Placement::AtOnce},
                            [&](const SessionEvent& event) { (*recorder)->append(event); });
    int ticks = 0;
    note(**recorder, ticks);
    EXPECT_TRUE(runTouchPath(path, session, [&](double, const Tick&) { note(**recorder, ++ticks); }));
    EXPECT_TRUE((*recorder)->close(model->hash()));
    return model->hash();
}

}  // namespace tactooth::test
