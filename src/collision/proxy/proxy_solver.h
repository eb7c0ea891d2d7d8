// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "collision/proxy/move_result.h"
#include "collision/proxy/proxy_context.h"
#include "collision/proxy/settled_state.h"
#include "collision/proxy/sweep_check.h"

namespace tactooth {

/// A rigid tool that moves among the triangles of a tooth and never enters them: the proxy (or god object) of haptics,
/// with the tool's own STL as its shape. Each move goes toward a goal pose and slides along what blocks it. It ends
/// where the distance to the goal is locally least.
///
/// With six degrees of freedom the distance is that of Gauss' principle of least constraint: the square of the shift of
/// the tool's centre, plus the square of the rotation vector times `characteristicLength`. So with turn = from goal to
/// pose, characteristicLength^2 * turn = sum over the contacts of multiplier * lever x normal; the lever goes from the
/// centre to the contact.
///
/// Fixed memory: a move allocates nothing. One thread at a time.
class ProxySolver {
public:
    explicit ProxySolver(std::shared_ptr<const ToolShape> tool, Freedom freedom = Freedom::Translation);

    /// Puts the proxy among the triangles of `surface`. Returns the surface before, so that the caller decides where it
    /// is freed.
    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface);
    /// The same with a neighbour list built ahead (by another thread) for this surface and this tool. The next moves
    /// need not build one, as long as they stay within it. `near` gets the old list.
    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface, NeighbourList& near);

    /// Puts the proxy at a pose that is free of contact (the caller knows; see isFree in contact_query.h).
    void placeAt(const Pose& toolInTooth);
    /// Puts the proxy at a pose that is free of contact, not far away: the neighbour list stays.
    void shiftTo(const Pose& toolInTooth);
    /// Whether the tool would be clear of all triangles at a pose (it may still be wholly inside). None if the
    /// neighbour list does not cover the pose.
    [[nodiscard]] std::optional<bool> isClearAt(const Pose& toolInTooth);
    /// Forgets what earlier moves have found out. After placeAt, later moves do not depend on it to the last bit.
    void forget();

    /// Limits the work of each move, beside the building of one neighbour list; see WorkBudget. A move that has used up
    /// its budget stops where it is. The next move continues from there with twice the budget. Unlimited at first.
    void setBudget(Work budget) { context_.budget.setLimit(budget); }

    /// Moves toward `goal` and sweeps the whole displacement: nothing is passed through, whatever the length of the
    /// move. A settled proxy stays where it is, bit for bit and without work, until goal or surface change. Needs a
    /// surface.
    MoveResult moveToward(const Pose& goal);

    /// How often the proxy has had to build a neighbour list itself.
    [[nodiscard]] std::uint32_t ownListRebuilds() const { return context_.horizon.ownRebuilds(); }

    /// Of the tool, in the tooth's frame.
    [[nodiscard]] const Pose& pose() const { return context_.scene.pose; }
    [[nodiscard]] const ToolShape& tool() const { return *context_.scene.tool; }
    /// Null until the first setSurface.
    [[nodiscard]] const Surface* surface() const { return context_.scene.surface.get(); }
    /// The distance that the proxy keeps from the tooth, mm: far below what any device or eye resolves, far above the
    /// rounding of doubles.
    [[nodiscard]] double margin() const { return context_.scene.margin; }
    /// The length that weighs a rotation against a shift: the radius of gyration of a rod as long as the tool, mm.
    [[nodiscard]] double characteristicLength() const { return context_.scene.characteristicLength(); }

private:
    void enter(std::shared_ptr<const Surface>& surface);

    ProxyContext context_;
    SweepCheck sweep_;
    SettledState settled_;
};

}  // namespace tactooth
