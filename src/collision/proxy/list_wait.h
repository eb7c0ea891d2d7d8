// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/assert.h"

namespace tactooth {

/// Decides whether a proxy at the end of its neighbour list waits for the next one.
///
/// Another thread may build lists ahead of need. To build one in the move itself takes longer than the rest of the
/// move, so a proxy with a budget waits a few moves for a given list before it builds its own. Waiting ends after
/// kMaxWaits moves: a list for a bur of 2.3 mm in its own cavity comes within eight ticks.
class ListWait {
public:
    static constexpr int kMaxWaits = 8;  // moves

    /// The proxy got a list from outside.
    void listGiven() {
        isExternal_ = hasProvider_ = true;
        waits_ = rests_ = 0;
    }
    /// The proxy built a list of its own.
    void listBuilt() { isExternal_ = false; }

    /// Whether a proxy at the end of a given list may wait: for kMaxWaits moves, or without limit while the list is
    /// still fresh (NeighbourHorizon::isFresh). In a fresh list contacts hold the proxy, and its own list would not let
    /// it move on either.
    [[nodiscard]] bool mayWait(bool isListFresh) const { return isExternal_ && (waits_ < kMaxWaits || isListFresh); }
    /// Counts a move that waited, or ends the count.
    void endMove(bool hasWaited) { waits_ = hasWaited ? waits_ + 1 : 0; }

    /// A list came out too long to be built in one move. If somebody provides lists, the proxy rests kMaxWaits moves
    /// before it builds a shorter one.
    void beginRest() { rests_ = hasProvider_ ? kMaxWaits : 0; }
    void endRest() { rests_ = 0; }
    /// Whether this move is one of rest; counts it.
    [[nodiscard]] bool takeRest() {
        TACTOOTH_ASSERT(rests_ >= 0 && rests_ <= kMaxWaits);
        if (rests_ == 0) return false;
        --rests_;
        return true;
    }

private:
    bool isExternal_ = false;   // the present list was given
    bool hasProvider_ = false;  // somebody has given a list before
    int waits_ = 0;             // successive moves that ended at the end of a given list
    int rests_ = 0;             // moves left to stand still
};

}  // namespace tactooth
