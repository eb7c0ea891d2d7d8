// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "haptics/haptic_simulation.h"
#include "haptics/haptic_surface.h"
#include "session/kernel/session_event.h"

namespace tactooth {

/// The result of a turn of the carving thread that has changed the tooth.
struct CarvedSurface {
    std::shared_ptr<const Surface> surface;  ///< all that the tool can touch
    std::optional<Pose> reached;             ///< the end of the cut
};

/// The part of a session that the neighbour-list thread runs: it builds neighbour lists for each new surface and along
/// the path of the tool. It also finds a start pose for a tool whose device began inside the tooth. Equal calls give
/// equal lists, bit for bit.
class ListingStage {
public:
    /// Neither pointer is null. It finds start poses only where their placement is deferred.
    ListingStage(std::shared_ptr<const ToolShape> tool, const std::shared_ptr<const Surface>& surface,
                 Placement placement = Placement::Deferred);

    /// One turn. `now`: the newest tick. `cut`: the newest surface, if there is a new one. Returns a surface to send to
    /// the servo thread, or null if it needs none. This object owns the result. Call `sent` or `recycle` with it.
    [[nodiscard]] HapticSurface* turn(const Tick& now, std::optional<CarvedSurface> cut);
    /// The result of the last turn is on its way to the servo thread.
    void sent() { unsent_.reset(); }
    /// Takes back a result, with whatever it holds now: from the servo thread, or one that could not be sent. A surface
    /// that could not be sent is offered again by the next turn.
    void recycle(HapticSurface* hapticSurface) { surfaces_.recycle(hapticSurface); }
    /// Whether the next turn has work even if no new tick or surface has come.
    [[nodiscard]] bool hasUnsent() const { return unsent_.has_value(); }

private:
    HapticSurfaceBuilder surfaces_;
    std::shared_ptr<const Surface> newest_;
    std::optional<CarvedSurface> unsent_;
    Placement placement_;
};

}  // namespace tactooth
