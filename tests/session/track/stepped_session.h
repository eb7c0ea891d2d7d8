// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <memory>

#include "session/kernel/carving_stage.h"
#include "session/kernel/event_lanes.h"
#include "session/kernel/listing_stage.h"
#include "session/kernel/servo_stage.h"

namespace tactooth::test {

/// A session as the LiveRunner runs it, but by one thread and without a clock: as fast as the machine can, and the same
/// each time. It reports its events like the threads of the LiveRunner.
class SteppedSession {
public:
    static constexpr int kTicksOfATurn = 4;  ///< ticks between two turns of carving and neighbour lists
    static constexpr double kPeriod = 1e-3;  ///< s

    SteppedSession(std::shared_ptr<CutModel> model, const Instrument& instrument, const HapticSettings& settings,
                   std::shared_ptr<EventLanes> lanes)
        : model_(std::move(model)),
          lanes_(std::move(lanes)),
          servo_(instrument, model_->contactSurface(), settings),
          carving_(model_, instrument, settings.materials),
          listing_(servo_.tool(), servo_.surface()) {}

    const Tick& step(const OperatorInput& hand) {
        const auto taken = static_cast<std::uint32_t>(pending_.size());
        for (HapticSurface* one : pending_) servo_.take(*one), retired_.push_back(one);
        pending_.clear();
        const TickInput input = TickInput::of(hand, elapsed_.next(kPeriod));
        tick_ = servo_.step(input);
        lanes_->servo(TickEvent{input, taken});
        if (tick_.number % 1000 == 0) lanes_->servo(TickHashEvent{servo_.hash()});
        if (tick_.number % kTicksOfATurn != 0) return tick_;
        const bool changed = carving_.carve(tick_);
        lanes_->carving(CarveEvent{tick_.number, changed});
        turnLists(changed);
        return tick_;
    }
    void edit(Edit edit) {
        const bool changed = carving_.edit(edit);
        lanes_->carving(EditEvent{edit, changed});
        turnLists(changed);
    }

    [[nodiscard]] TickNumber ticks() const { return tick_.number; }

private:
    void turnLists(bool changed) {
        std::optional<CarvedSurface> cut;
        if (changed) cut = CarvedSurface{model_->contactSurface(), model_->reached()};
        const auto recycled = static_cast<std::uint32_t>(retired_.size());
        for (HapticSurface* one : retired_) listing_.recycle(one);
        retired_.clear();
        HapticSurface* const made = listing_.turn(tick_, std::move(cut));
        if (made != nullptr) listing_.sent(), pending_.push_back(made);
        lanes_->listing(ListEvent{tick_.number, changed ? ++published_ : 0, recycled, made != nullptr});
    }

    std::shared_ptr<CutModel> model_;
    std::shared_ptr<EventLanes> lanes_;
    ServoStage servo_;
    CarvingStage carving_;
    ListingStage listing_;
    ElapsedTime elapsed_;
    Tick tick_;
    SurfaceNumber published_ = 0;
    std::deque<HapticSurface*> pending_, retired_;
};

}  // namespace tactooth::test
