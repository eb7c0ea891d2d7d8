// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "collision/neighbours/neighbour_list.h"
#include "collision/proxy/list_wait.h"
#include "collision/proxy/proxy_scene.h"

namespace tactooth {

/// The neighbour list of a proxy: what it covers, when it is rebuilt and for what motion.
///
/// A list covers a contact margin around the pose that it was built for. The horizon trusts 95 % of that margin, which
/// leaves room for rounding.
class NeighbourHorizon {
public:
    explicit NeighbourHorizon(const ToolShape& tool) : list_(tool) {}

    [[nodiscard]] NeighbourList& list() { return list_; }
    [[nodiscard]] const NeighbourList& list() const { return list_; }
    [[nodiscard]] ListWait& wait() { return wait_; }

    /// Whether the list covers a position of the tool's origin, with `margin` mm to spare.
    [[nodiscard]] bool coversPosition(const Vec3& position, double margin) const {
        TACTOOTH_ASSERT(margin >= 0);
        return list_.deviation(position) <= list_.contactMargin().around * kTrusted - margin;
    }
    /// Whether there is a list and it covers a pose.
    [[nodiscard]] bool covers(const Pose& pose, double margin) const;
    /// How much further the tool may rotate from an orientation, as a chord; negative: it is beyond the list.
    [[nodiscard]] double rotationLeft(const Quat& rotation) const {
        return list_.contactMargin().turn * kTrusted - list_.chordTo(rotation);
    }
    /// Whether a long list has a good part of its contact margin left.
    [[nodiscard]] bool isFresh(const Pose& pose) const;
    /// The share (0 to 1) of a step of the tool's origin that the list covers.
    [[nodiscard]] double coveredShare(const ProxyScene& scene, const Vec3& step) const;

    /// Starts a move whose goal lies so far from where the last move led (mm, and as a chord).
    void beginMove(double goalShift, double goalRotation);
    /// How far the goal went in this move, mm.
    [[nodiscard]] double goalShift() const { return goalShift_; }
    /// Whether a proxy at the end of its list may wait for the next one; see ListWait.
    [[nodiscard]] bool mayWait(const Pose& pose, bool isBudgetLimited) const;
    /// Whether the list would end on the displacement expected in this move.
    [[nodiscard]] bool isExhausted(const Pose& pose, const Vec3& displacement, double turn, bool isBudgetLimited) const;
    /// Whether this move may build one more list.
    [[nodiscard]] bool mayRebuild(double toolRadius) const;
    /// Builds a list for the displacement (mm) and rotation (chord) expected in this move, and some more. Each list
    /// beyond the eighth of a move covers twice as much as the one before.
    void rebuild(const ProxyScene& scene, const Vec3& displacement, double turn);
    /// Clears a list that is full, for a shorter one in its place. False if the list is not full or cannot be shorter.
    [[nodiscard]] bool shortenFullList() { return list_.isFull() && list_.shorten(); }
    /// The next list takes the place of the one built last.
    void discountRebuild() { rebuilds_ = rebuilds_ > 0 ? rebuilds_ - 1 : 0; }
    /// Takes a list that was built ahead. `near` gets the old one.
    void take(NeighbourList& near);

    /// Lists built in this move.
    [[nodiscard]] int rebuilds() const { return rebuilds_; }
    /// Lists built by the proxy itself, ever.
    [[nodiscard]] std::uint32_t ownRebuilds() const { return ownRebuilds_; }

private:
    static constexpr double kTrusted = 0.95;  // of the contact margin

    NeighbourList list_;
    ListWait wait_;
    double goalShift_ = 0;     // mm
    double goalRotation_ = 0;  // chord
    int rebuilds_ = 0;
    std::uint32_t ownRebuilds_ = 0;
};

}  // namespace tactooth
