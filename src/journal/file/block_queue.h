// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "journal/format/container_blocks.h"
#include "journal/format/journal_block.h"

namespace tactooth {

/// Blocks that wait to be written, at most so many. What has no room is dropped and counted; the count goes with the
/// next block that has room, so that the file says where blocks are missing. Its user locks it.
class BlockQueue {
public:
    struct Entry {
        std::optional<LostFacts> lostBefore;
        JournalBlock block;
    };
    struct Limits {
        std::size_t blocks, bytes;  ///< bytes of the payloads
    };

    explicit BlockQueue(const Limits& limits);

    /// A block always has room in an empty queue.
    [[nodiscard]] bool hasRoomFor(const JournalBlock& block) const;
    void push(JournalBlock block);
    void drop(const JournalBlock& block) { lost_.add(block); }

    [[nodiscard]] bool empty() const { return entries_.empty(); }
    [[nodiscard]] std::vector<Entry> takeAll();
    /// What was dropped behind the last entry.
    [[nodiscard]] std::optional<LostFacts> takeLost();

private:
    Limits limits_;
    std::vector<Entry> entries_;
    std::size_t bytes_ = 0;  // of the payloads of entries_
    LostFacts lost_;         // behind the last entry
};

}  // namespace tactooth
