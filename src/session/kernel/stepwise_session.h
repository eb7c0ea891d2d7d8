// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "session/kernel/carving_stage.h"
#include "session/kernel/listing_stage.h"
#include "session/kernel/servo_stage.h"
#include "session/kernel/session_event.h"
#include "session/kernel/sweep_stage.h"

namespace tactooth {

/// A session that is not live: one thread, no clock, one call after the other. It has the stages of a live session, and
/// reports each call as an event. The same events give the same session in a SessionKernel, bit for bit.
class StepwiseSession {
public:
    using EventSink = std::function<void(const SessionEvent&)>;

    /// The model is not null. `begin` is the first event. `sink` receives the events; without it they are lost.
    StepwiseSession(std::shared_ptr<CutModel> model, const BeginEvent& begin, EventSink sink = {});

    /// Moves the tool. `elapsed`: since the last tick, not negative; `time`: as the run counts it; s.
    Tick step(const OperatorInput& input, double elapsed, double time);
    /// Cuts behind the newest tick (CarvingStage::carve). Returns true if the surface has changed.
    bool carve();
    /// Makes the neighbour list for the next tick, if it needs a new one. Call it after each tick and its cut.
    void list();
    /// Moves a rigid bur that removes all that it sweeps (SweepStage). A session either steps or sweeps.
    Tick sweep(const Pose& tool, double elapsed, double time, bool spins);
    /// The end (CarvingStage::finish).
    void finish(bool dropsPieces);

    [[nodiscard]] const CutModel& model() const { return *model_; }

private:
    void report(const SessionEvent& event) const;
    void reportHashes();

    std::shared_ptr<CutModel> model_;
    BeginEvent begin_;
    EventSink sink_;
    ServoStage servo_;
    CarvingStage carving_;
    ListingStage listing_;
    std::optional<SweepStage> sweep_;
    Tick newest_;
    HapticSurface* pending_ = nullptr;  // for the next tick
    HapticSurface* retired_ = nullptr;  // taken, not recycled yet
    SurfaceNumber published_ = 0;
    SurfaceNumber listed_ = 0;  // the newest one that listing has received
    double nextHash_ = 0;       // Tick::time, s
};

}  // namespace tactooth
