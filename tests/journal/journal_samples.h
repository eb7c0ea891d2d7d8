// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/byte_stream.h"
#include "journal/codec/integer_columns.h"
#include "journal/file/journal_reader.h"
#include "journal/format/journal_block.h"

namespace tactooth::test {

/// The header of all samples.
inline constexpr std::string_view kSampleHeader = R"({"build":"test","seed":7,"case":"molar \u00e4"})";
inline constexpr std::uint32_t kSampleTicks = 100;  ///< of a block of events

/// A path of a hand with a pedal, as the events of `rows` ticks.
[[nodiscard]] std::vector<IntegerColumn> sampleColumns(std::mt19937& random, std::size_t rows);

/// Seconds of a session: each has two blocks of events, a hash and a keyframe; then a note, and a block of a type that
/// nobody knows. The first block is an attachment.
[[nodiscard]] std::vector<JournalBlock> sampleBlocks(unsigned seed, int seconds);

/// The bytes of a recording of these blocks, with its end or without it.
[[nodiscard]] std::vector<std::byte> journalBytes(std::span<const JournalBlock> blocks, bool hasEnd,
                                                  std::string_view header = kSampleHeader);

/// Expects that a reader gives these blocks at the beginning, byte for byte.
void expectBlocks(const JournalReader& journal, std::span<const JournalBlock> blocks);

}  // namespace tactooth::test
