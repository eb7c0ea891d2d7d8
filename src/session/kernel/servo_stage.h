// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "geometry/util/fnv1a.h"
#include "session/kernel/instrument.h"
#include "session/kernel/session_event.h"

namespace tactooth {

/// Adds the results of a tick to a hash: poses, force, contacts, speed and work.
void addToHash(Fnv1a& hash, const Tick& tick);

/// The part of a session that the servo thread runs: it moves the tool and computes the force. Equal calls give equal
/// ticks, bit for bit. It allocates, locks and logs nothing, and reads no clock.
class ServoStage {
public:
    /// `surface` is the one that the tool is in at first; not null.
    ServoStage(const Instrument& instrument, std::shared_ptr<const Surface> surface, const HapticSettings& settings,
               Placement placement = Placement::Deferred);

    void setForce(const ForceParameters& parameters);
    /// Takes a surface with its neighbour list; the ones before stay in `hapticSurface`.
    void take(HapticSurface& hapticSurface) { simulation_.setSurface(hapticSurface); }
    [[nodiscard]] Tick step(const TickInput& input) { return step(input.operatorInput(), input.seconds()); }
    /// The same with numbers that are not on the grid, for a run that is not live.
    [[nodiscard]] Tick step(const OperatorInput& input, double elapsed);

    [[nodiscard]] const std::shared_ptr<const ToolShape>& tool() const { return simulation_.tool(); }
    /// The surface that the tool is in.
    [[nodiscard]] const std::shared_ptr<const Surface>& surface() const { return simulation_.surface(); }
    /// Hash of the results of all ticks so far (addToHash).
    [[nodiscard]] std::uint64_t hash() const { return hash_.value(); }

private:
    HapticSimulation simulation_;
    std::uint32_t ticks_ = 0;
    Fnv1a hash_;
};

}  // namespace tactooth
