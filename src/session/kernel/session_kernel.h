// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "session/kernel/carving_stage.h"
#include "session/kernel/listing_stage.h"
#include "session/kernel/servo_stage.h"
#include "session/kernel/session_event.h"
#include "session/kernel/sweep_stage.h"

namespace tactooth {

/// A session without threads and clock: the same events give the same ticks, forces and tooth as in the session that
/// they were recorded in, bit for bit. One thread.
class SessionKernel {
public:
    /// `model` is not null. It is as it was when the recording began.
    explicit SessionKernel(std::shared_ptr<CutModel> model);
    ~SessionKernel();
    SessionKernel(const SessionKernel&) = delete;
    SessionKernel& operator=(const SessionKernel&) = delete;

    /// False if the event cannot follow those before it, or if its outcome differs from the recorded one: then the
    /// recording is of another program, or damaged. Nothing may be applied after that. The first event is a BeginEvent.
    [[nodiscard]] bool apply(const SessionEvent& event);

    /// The newest tick; its number is 0 before the first one.
    [[nodiscard]] const Tick& tick() const { return newest_; }
    [[nodiscard]] const CutModel& model() const { return *model_; }
    /// Of all ticks since the last BeginEvent; 0 before it.
    [[nodiscard]] std::uint64_t tickHash() const { return sweep_ ? sweep_->hash() : servo_ ? servo_->hash() : 0; }
    /// CutVolume::hash.
    [[nodiscard]] std::uint64_t toothHash() const { return model_->hash(); }

private:
    [[nodiscard]] bool on(const BeginEvent& event);
    [[nodiscard]] bool on(const ForceEvent& event);
    [[nodiscard]] bool on(const TickEvent& event);
    [[nodiscard]] bool on(const CarveEvent& event);
    [[nodiscard]] bool on(const EditEvent& event);
    [[nodiscard]] bool on(const ListEvent& event);
    [[nodiscard]] bool on(const TickHashEvent& event);
    [[nodiscard]] bool on(const CarvingHashEvent& event);
    [[nodiscard]] bool on(const ExactTickEvent& event);
    [[nodiscard]] bool on(const FinishEvent& event);
    [[nodiscard]] bool take(std::uint32_t count);
    [[nodiscard]] bool canCut() const;
    [[nodiscard]] bool publish(bool changed, bool recorded);
    [[nodiscard]] const Tick* tickAt(TickNumber number) const;
    void forgetOldTicks();

    std::shared_ptr<CutModel> model_;
    std::optional<ServoStage> servo_;
    std::optional<CarvingStage> carving_;
    std::optional<ListingStage> listing_;
    std::optional<SweepStage> sweep_;  // made by the first swept tick
    std::optional<BeginEvent> begin_;

    Tick newest_;
    std::deque<Tick> ticks_;               // that carving or listing may still look at, oldest first
    TickNumber carvedAt_ = 0;              // the newest tick that the carving stage has seen
    TickNumber listedAt_ = 0;              // the newest tick that the listing stage has seen
    std::deque<CarvedSurface> published_;  // not received yet, oldest first
    SurfaceNumber received_ = 0;           // the number of the surface before the first of these
    std::deque<HapticSurface*> pending_;   // sent and not taken yet, oldest first
    std::deque<HapticSurface*> retired_;   // taken and not recycled yet, oldest first
};

}  // namespace tactooth
