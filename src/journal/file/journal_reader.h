// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/util/expected.h"
#include "journal/file/byte_source.h"
#include "journal/file/journal_scan.h"
#include "journal/format/journal_block.h"

namespace tactooth {

/// Ticks from the first one to the one before `end`.
struct TickRange {
    std::uint64_t begin = 0, end = 0;
    [[nodiscard]] bool operator==(const TickRange&) const = default;
};

/// An open recording, up to the last block that is whole. It may still be recorded: what is appended later is not seen.
/// The file is not kept in memory. Any thread may use the const functions.
class JournalReader {
public:
    /// Checks the whole file. Fails with one sentence as scanJournal does, or if the file cannot be read.
    [[nodiscard]] static Expected<JournalReader> open(const std::filesystem::path& path);
    /// `bytes` outlive the reader; `name` stands for them in messages.
    [[nodiscard]] static Expected<JournalReader> parse(std::span<const std::byte> bytes, std::string name);

    /// Name of the file for messages.
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::string& headerJson() const { return scan_.headerJson; }
    /// In the order of the file, types that this version does not know among them.
    [[nodiscard]] std::span<const BlockPlace> blocks() const { return scan_.blocks; }
    /// Size of the file.
    [[nodiscard]] std::uint64_t bytes() const { return source_->size(); }

    /// Whether the recording was ended, and not cut off by a crash.
    [[nodiscard]] bool isComplete() const;
    /// Whether the file ends with what a repair appended.
    [[nodiscard]] bool isRecovered() const;
    /// The byte from which on the file is no recording any more; none if everything can be read.
    [[nodiscard]] std::optional<std::uint64_t> cutOffAt() const;
    /// The ticks that the blocks cover together; none if no block covers a tick.
    [[nodiscard]] std::optional<TickRange> ticks() const;

    /// What a block holds. Takes at most kMaxStoredBytes + kMaxRawBytes of memory. Fails with one sentence if it cannot
    /// be unpacked, or has changed since the file was opened.
    [[nodiscard]] Expected<std::vector<std::byte>> payload(const BlockPlace& block) const;
    /// The same as it is in the file.
    [[nodiscard]] Expected<std::vector<std::byte>> storedPayload(const BlockPlace& block) const;

    /// The first block of this type that covers the tick; null if there is none.
    [[nodiscard]] const BlockPlace* blockAt(BlockType type, std::uint64_t tick) const;
    /// The last keyframe at or before the tick, to replay from; null if there is none.
    [[nodiscard]] const BlockPlace* keyframeBefore(std::uint64_t tick) const;

    [[nodiscard]] const JournalScan& scan() const { return scan_; }
    [[nodiscard]] const ByteSource& source() const { return *source_; }

private:
    JournalReader(std::unique_ptr<ByteSource> source, std::string name, JournalScan scan);
    [[nodiscard]] static Expected<JournalReader> read(std::unique_ptr<ByteSource> source, std::string name);

    std::unique_ptr<ByteSource> source_;
    std::string name_;
    JournalScan scan_;
};

}  // namespace tactooth
