// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"
#include "journal/file/journal_file.h"
#include "journal/file/journal_sealer.h"
#include "journal/format/block_encoder.h"
#include "journal/format/container_blocks.h"

namespace tactooth {

/// Writes blocks into a file, one whole block after the other, and the end. After the first failure it writes nothing
/// more: a half block may be the last thing in a file, and no block follows it. For one thread.
class JournalAppender {
public:
    /// Writes the header, brings it to the disk and names the file. `name`: of the file, for messages. `seal`: signs
    /// the recording at each sync and at its end; the header then says so, and names the public key. Null: unsealed.
    [[nodiscard]] static Expected<JournalAppender> begin(std::unique_ptr<JournalFile> file, std::string name,
                                                         std::string_view headerJson,
                                                         std::shared_ptr<const SigningKey> seal = {});

    /// Each returns whether the block is written as a whole. A block that is too large for the format is lost, and the
    /// next one is written all the same.
    bool append(const JournalBlock& block);
    /// A block of another file, as it is stored there.
    bool appendStored(const BlockHeader& header, std::span<const std::byte> stored);
    /// Says in the file which blocks were dropped before they came here.
    bool appendLost(const LostFacts& facts);

    /// Brings what was written to the disk.
    bool sync();
    /// Writes the index and the clean end, and syncs. The last call.
    bool end(std::uint64_t tick);

    /// What stopped the writing, as a sentence.
    [[nodiscard]] const std::optional<Message>& fault() const { return fault_; }
    /// Whether something is written that is not synced.
    [[nodiscard]] bool isDirty() const { return isDirty_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    [[nodiscard]] std::uint64_t blocks() const { return blocks_; }

private:
    JournalAppender(std::unique_ptr<JournalFile> file, std::string name, std::uint32_t headerCrc);

    [[nodiscard]] bool canWrite();
    bool seal(std::uint64_t tick, SealPoint point);
    bool writeBlock(BlockType type, std::uint64_t firstTick, std::uint32_t ticks, std::span<const std::byte> bytes);
    bool write(std::span<const std::byte> bytes);
    bool stop(int failure);
    bool stop(Message why);

    std::unique_ptr<JournalFile> file_;
    std::string name_;
    BlockEncoder encoder_;
    std::optional<JournalSealer> sealer_;
    std::vector<KeyframePlace> keyframes_;
    std::optional<Message> fault_;
    std::uint64_t bytes_ = 0, blocks_ = 0, lostBlocks_ = 0;
    std::uint64_t endTick_ = 0;  // of all blocks
    bool isDirty_ = false;
};

}  // namespace tactooth
