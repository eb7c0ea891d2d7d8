// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/session_replay.h"

#include <utility>

namespace tactooth {

SessionReplay::SessionReplay(const SessionRecording& recording, std::shared_ptr<CutModel> model)
    : recording_(&recording), kernel_(std::make_unique<SessionKernel>(std::move(model))) {}

Expected<SessionReplay> SessionReplay::start(const SessionRecording& recording) {
    Expected<std::shared_ptr<CutModel>> model = recording.makeModel();
    if (!model) return Unexpected{model.error()};
    return SessionReplay(recording, std::move(*model));
}

/// The time after an event. A run that is not live counts its own time, which a sum of rounded numbers would miss.
double SessionReplay::timeOf(const SessionEvent& event) {
    if (std::holds_alternative<BeginEvent>(event)) runStart_.reset();
    const auto* const exact = std::get_if<ExactTickEvent>(&event);
    if (exact == nullptr) return seconds_ + secondsOf(event).value_or(0);
    if (!runStart_) runStart_ = exact->time - seconds_;
    return exact->time - *runStart_;
}

Expected<void> SessionReplay::playUntil(std::optional<double> end, const TickCallback& onTick,
                                        const EventCallback& onEvent) {
    bool stopped = false;
    const auto played = recording_->forEach([&](const SessionEvent& event) {
        const std::optional<double> elapsed = secondsOf(event);
        const double next = timeOf(event);
        stopped = end && next > *end;
        if (stopped) return false;
        seconds_ = next;
        if (!kernel_->apply(event)) differsAt_ = seconds_;
        if (differsAt_) return false;
        if (const auto* begin = std::get_if<BeginEvent>(&event)) bur_ = *begin;
        if (onEvent) onEvent(seconds_, event);
        if (!elapsed) return true;
        ++ticks_;
        if (onTick) onTick(seconds_, kernel_->tick());
        return true;
    });
    if (!played || stopped || differsAt_) return played;
    const Expected<RecordedEnd> recorded = recording_->end();
    if (!recorded) return Unexpected{recorded.error()};
    if (recorded->toothHash && *recorded->toothHash != kernel_->toothHash()) differsAt_ = seconds_;
    return {};
}

}  // namespace tactooth
