// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "session/kernel/stepwise_session.h"
#include "session/simulation/cut_events.h"
#include "session/simulation/spray_particle_system.h"
#include "sound/output/offline_render.h"

namespace tactooth {

/// The results of a demonstration.
struct Demonstration {
    std::vector<Tick> ticks;             ///< one a millisecond
    std::vector<TimedSoundState> sound;  ///< one every five
    std::size_t touchTick = 0;           ///< the last tick of the touching part
    std::uint64_t surfaceUpdates = 0;
    std::vector<CutEvent> events;
    /// The last tick in which the bur cut with the pedal down, and so with water.
    struct Work {
        std::size_t tick = 0;
        std::shared_ptr<const Surface> surface;
        std::vector<SprayParticle> flying;
    };
    std::optional<Work> work;  ///< empty if there was no such tick
};

/// Plays a session without clock, device or display. A scripted hand touches the tooth from above (+z), strokes it,
/// lifts, starts the turbine and cuts to and fro. `grip` is the orientation of the tool. Equal inputs give equal
/// results. `box`: of the tooth in `piece` that is worked on, mm. `progress` is called with 0..1. `sink` receives the
/// events of the session; it may be empty. Ends early when `stop` asks for it.
[[nodiscard]] Demonstration playDemonstration(const std::shared_ptr<CutModel>& piece, const Box3& box,
                                              const Instrument& instrument, const HapticSettings& settings,
                                              const Quat& grip, double seconds,
                                              const std::function<void(double)>& progress,
                                              const StepwiseSession::EventSink& sink = {},
                                              const std::stop_token& stop = {});

}  // namespace tactooth
