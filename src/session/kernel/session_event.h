// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>

#include "haptics/haptic_simulation.h"
#include "session/kernel/instrument.h"
#include "session/kernel/tick_input.h"

// The events of a session. Each part of a running session is a pure function of its state and its events. What depends
// on time and threads is only which event comes after which: when a surface reaches the servo thread, which tick the
// carving thread sees. The events say that by numbers: of ticks, of published surfaces, of surfaces that were sent. So
// the same events give the same session, bit for bit, however fast they come.

namespace tactooth {

/// Number of a tick since the last BeginEvent, from 1; 0: none yet.
using TickNumber = std::uint32_t;
/// Number of a surface that carving has published since the last BeginEvent, from 1; 0: none.
using SurfaceNumber = std::uint32_t;

/// How a tool that begins inside the tooth gets its first pose.
enum class Placement : std::uint8_t {
    Deferred,  ///< the neighbour-list thread finds it, because that takes longer than a tick may last
    AtOnce     ///< the tick finds it itself, in a run that is not live
};

/// A bur begins to work on the tooth, with these settings. The tooth keeps its cuts.
struct BeginEvent {
    Instrument instrument;
    HapticSettings settings;
    Placement placement = Placement::Deferred;
};

/// The force parameters of all later ticks.
struct ForceEvent {
    ForceParameters parameters;
};

/// One tick of the servo thread.
struct TickEvent {
    TickInput input;
    std::uint32_t taken = 0;  ///< number of surfaces that the servo thread has taken just before
};

/// One turn of the carving thread.
struct CarveEvent {
    TickNumber tick = 0;     ///< the newest one that it saw
    bool published = false;  ///< whether the surface has changed
};

/// The user's changes of the tooth, carried out by the carving thread.
enum class Edit : std::uint8_t { Reset = 0, Undo = 1, Redo = 2 };
struct EditEvent {
    Edit edit = Edit::Reset;
    bool published = false;  ///< whether the surface has changed
};

/// The hash of all ticks so far (ServoStage::hash).
struct TickHashEvent {
    std::uint64_t hash = 0;
};
/// The hash of all turns of the carving thread so far (CarvingStage::hash).
struct CarvingHashEvent {
    std::uint64_t hash = 0;
};

/// One turn of the neighbour-list thread.
struct ListEvent {
    TickNumber tick = 0;         ///< the newest one that it saw
    SurfaceNumber surface = 0;   ///< that it has received in this turn
    std::uint32_t recycled = 0;  ///< number of lists that the servo thread had given back
    bool sent = false;           ///< whether its surface was sent to the servo thread
};

/// One tick of a run that is not live: a script or a table gives its input. It is not on the grid of TickInput, so that
/// a run has the same numbers whether it is recorded or not.
struct ExactTickEvent {
    OperatorInput input;
    double elapsed = 0;       ///< since the last tick, s; not negative
    double time = 0;          ///< as the run counts it, s
    bool swept = false;       ///< the bur removes all that it sweeps (SweepStage); nothing resists
    std::uint32_t taken = 0;  ///< as TickEvent::taken
};

/// The end of a run that is not live.
struct FinishEvent {
    bool dropsPieces = false;  ///< whether detached pieces fall now
    bool published = false;    ///< whether the surface has changed
};

using SessionEvent = std::variant<BeginEvent, ForceEvent, TickEvent, CarveEvent, EditEvent, ListEvent, TickHashEvent,
                                  CarvingHashEvent, ExactTickEvent, FinishEvent>;

/// Whether something was cut from the tooth, or put back.
[[nodiscard]] inline bool changesTooth(const SessionEvent& event) {
    const auto* const carve = std::get_if<CarveEvent>(&event);
    const auto* const edit = std::get_if<EditEvent>(&event);
    return (carve != nullptr && carve->published) || (edit != nullptr && edit->published);
}

/// The time that a tick has taken, s; nothing for an event that is no tick.
[[nodiscard]] inline std::optional<double> secondsOf(const SessionEvent& event) {
    if (const auto* const tick = std::get_if<TickEvent>(&event)) return tick->input.seconds();
    if (const auto* const tick = std::get_if<ExactTickEvent>(&event)) return tick->elapsed;
    return std::nullopt;
}

}  // namespace tactooth
