// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "geometry/util/expected.h"

namespace tactooth {

struct JournalRepair {
    std::size_t blocks = 0;  ///< that were kept
    std::uint64_t keptBytes = 0;
    std::uint64_t droppedBytes = 0;
    bool hadEnd = false;  ///< there was nothing to repair, but for bytes behind the end
};

/// Writes the whole blocks of a recording that was cut off, byte for byte, and a Recovered block behind them. A
/// recording with an end (Closed or Recovered) is copied. `out` is written as a whole or not at all (AtomicFile). Fails
/// with one sentence as JournalReader::open and AtomicFile do. `header`: another JSON text for the header; then the
/// blocks are chained anew, and signatures, which would be wrong, are left out.
[[nodiscard]] Expected<JournalRepair> repairJournal(const std::filesystem::path& in, const std::filesystem::path& out,
                                                    const std::optional<std::string>& header = {});

}  // namespace tactooth
