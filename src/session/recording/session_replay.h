// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "session/kernel/session_kernel.h"
#include "session/recording/session_recording.h"

namespace tactooth {

/// A recorded session that is simulated again. One thread.
class SessionReplay {
public:
    /// Makes the tooth. `recording` outlives the replay. Fails with one sentence if it is damaged.
    [[nodiscard]] static Expected<SessionReplay> start(const SessionRecording& recording);

    /// Called after each tick, with the time since the session began, s.
    using TickCallback = std::function<void(double time, const Tick& tick)>;
    /// Called after each event of the recording, with the time since the session began, s.
    using EventCallback = std::function<void(double time, const SessionEvent& event)>;
    /// Plays from the start until `end` (s since the session began), or to the end of the recording. Stops where the
    /// replay differs from the recording. Call it once. Fails with one sentence if the recording is damaged.
    [[nodiscard]] Expected<void> playUntil(std::optional<double> end, const TickCallback& onTick,
                                           const EventCallback& onEvent = {});
    /// The newest tick (SessionKernel::tick).
    [[nodiscard]] const Tick& tick() const { return kernel_->tick(); }

    /// s since the session began
    [[nodiscard]] double seconds() const { return seconds_; }
    [[nodiscard]] std::uint64_t ticks() const { return ticks_; }
    [[nodiscard]] const CutModel& model() const { return kernel_->model(); }
    /// The bur at work; nothing before the first event.
    [[nodiscard]] const std::optional<BeginEvent>& bur() const { return bur_; }
    /// The time at which it was found that the replay differs from the recording, s; nothing if it does not.
    [[nodiscard]] const std::optional<double>& differsAt() const { return differsAt_; }

private:
    SessionReplay(const SessionRecording& recording, std::shared_ptr<CutModel> model);

    [[nodiscard]] double timeOf(const SessionEvent& event);

    const SessionRecording* recording_;
    std::unique_ptr<SessionKernel> kernel_;
    double seconds_ = 0;
    std::optional<double> runStart_;  // s, as a run that is not live counts; when its bur began
    std::uint64_t ticks_ = 0;
    std::optional<BeginEvent> bur_;
    std::optional<double> differsAt_;
};

}  // namespace tactooth
