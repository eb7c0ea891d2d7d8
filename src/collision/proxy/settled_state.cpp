// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/settled_state.h"

#include <algorithm>

namespace tactooth {

bool SettledState::isUnchanged(const ActiveContacts& contacts) const {
    if (contacts.count != heldCount_) return false;
    const auto before = std::span(held_).first(static_cast<std::size_t>(heldCount_));
    return std::ranges::all_of(contacts.all(), [&](const WatchedPair& watched) {
        return std::ranges::find(before, watched.pair) != before.end();
    });
}

void SettledState::endMove(const MoveResult& result, const ActiveContacts& contacts) {
    TACTOOTH_ASSERT(result.contactCount >= 0 && result.contactCount <= kMaxHeld);
    unchangedMoves_ = isUnchanged(contacts) ? unchangedMoves_ + 1 : 0;
    // A move that was cut short has not checked the pairs afresh.
    heldCount_ = result.status == MoveStatus::InContact ? contacts.count : 0;
    for (int i = 0; i < contacts.count; ++i) held_[i] = contacts.pairs[i].pair;
    isSettled_ = result.status == MoveStatus::InContact || result.status == MoveStatus::Reached;
    isLagging_ = result.status == MoveStatus::OutOfIterations;
    result_ = result;
    result_.iterations = result_.distances = 0;
    result_.work = 0;
}

}  // namespace tactooth
