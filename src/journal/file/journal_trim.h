// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "geometry/util/expected.h"
#include "journal/file/journal_reader.h"

namespace tactooth {

struct JournalTrim {
    TickRange ticks;         ///< that the new file covers; they keep their numbers
    std::size_t blocks = 0;  ///< of the old file that were kept
};

/// Writes the part of a recording that covers the ticks from `fromTick` to before `toTick`, as a recording of its own
/// that can be replayed: from the last keyframe at or before `fromTick`, else from the beginning. Blocks are kept as a
/// whole, so the part may begin and end a little outside of these ticks; its Trimmed block says what was asked for. The
/// header, attachments and blocks of unknown types are kept. `out` is written as a whole or not at all. Fails with one
/// sentence as JournalReader::open and AtomicFile do, or if nothing was recorded in these ticks. `fromTick` <=
/// `toTick`. Signatures are left out; `header`: another JSON text for the header, in place of one that names them.
[[nodiscard]] Expected<JournalTrim> trimJournal(const std::filesystem::path& in, const std::filesystem::path& out,
                                                std::uint64_t fromTick, std::uint64_t toTick,
                                                const std::optional<std::string>& header = {});

}  // namespace tactooth
