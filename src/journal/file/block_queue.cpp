// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/block_queue.h"

#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {

BlockQueue::BlockQueue(const Limits& limits) : limits_(limits) { TACTOOTH_ASSERT(limits.blocks > 0); }

bool BlockQueue::hasRoomFor(const JournalBlock& block) const {
    if (entries_.empty()) return true;
    return entries_.size() < limits_.blocks && bytes_ + block.payload.size() <= limits_.bytes;
}

void BlockQueue::push(JournalBlock block) {
    TACTOOTH_ASSERT(hasRoomFor(block));
    bytes_ += block.payload.size();
    entries_.push_back({takeLost(), std::move(block)});
    TACTOOTH_ASSERT(entries_.size() <= limits_.blocks);
}

std::vector<BlockQueue::Entry> BlockQueue::takeAll() {
    bytes_ = 0;
    return std::exchange(entries_, {});
}

std::optional<LostFacts> BlockQueue::takeLost() {
    if (lost_.blocks == 0) return std::nullopt;
    return std::exchange(lost_, {});
}

}  // namespace tactooth
