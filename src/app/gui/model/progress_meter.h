// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "assessment/cavity_metrics.h"
#include "session/model/task.h"

namespace tactooth {

/// Measures in the background how far a cavity has come, whenever the tooth has changed.
class ProgressMeter {
public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;
    /// No measurement begins sooner after the last one: a student looks up from the tooth no more often.
    static constexpr std::chrono::milliseconds kInterval{300};

    explicit ProgressMeter(const TaskExecutor& executor = runInThread, Clock clock = std::chrono::steady_clock::now)
        : task_(executor), clock_(std::move(clock)) {}

    /// Measures by `metrics` from now on, null: not at all. Drops what was measured before.
    void restart(std::shared_ptr<CavityMetrics> metrics);
    /// Call it in every step. `tooth`: its surface now; `removed`: so far, mm^3.
    void update(const std::shared_ptr<const Surface>& tooth, double removed);
    /// The newest result; none before the first one.
    [[nodiscard]] const std::optional<CavityProgress>& progress() const { return progress_; }

private:
    std::shared_ptr<CavityMetrics> metrics_;
    Task<CavityProgress> task_;
    Clock clock_;
    std::optional<CavityProgress> progress_;
    std::shared_ptr<const Surface> measured_;  // the tooth of the last measurement that began
    std::optional<std::chrono::steady_clock::time_point> began_;
};

}  // namespace tactooth
