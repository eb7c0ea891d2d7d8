// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "geometry/util/fnv1a.h"
#include "session/kernel/instrument.h"
#include "session/kernel/tick_input.h"

namespace tactooth {

/// The part of a session that the servo thread runs: it moves the tool and computes the force. Equal calls give equal
/// ticks, bit for bit. It allocates, locks and logs nothing, and reads no clock.
class ServoStage {
public:
    /// `surface` is the one that the tool is in at first; not null.
    ServoStage(const Instrument& instrument, std::shared_ptr<const Surface> surface, const HapticSettings& settings);

    void setForce(const ForceParameters& parameters);
    /// Takes a surface with its neighbour list; the ones before stay in `hapticSurface`.
    void take(HapticSurface& hapticSurface) { simulation_.setSurface(hapticSurface); }
    [[nodiscard]] Tick step(const TickInput& input);

    [[nodiscard]] const std::shared_ptr<const ToolShape>& tool() const { return simulation_.tool(); }
    /// The surface that the tool is in.
    [[nodiscard]] const std::shared_ptr<const Surface>& surface() const { return simulation_.surface(); }
    /// Hash of the results of all ticks so far: poses, force, contacts, speed and work.
    [[nodiscard]] std::uint64_t hash() const { return hash_.value(); }

private:
    void addToHash(const Tick& tick);

    HapticSimulation simulation_;
    std::uint32_t ticks_ = 0;
    Fnv1a hash_;
};

}  // namespace tactooth
