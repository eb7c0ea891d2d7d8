// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"
#include "journal/file/journal_reader.h"

namespace tactooth {

/// Largest attachment that is read, unless its reader says so: a packed case of a whole mouth takes a tenth of it.
inline constexpr std::size_t kMaxAttachmentBytes = std::size_t{512} << 20;

/// Puts a file together that the recording carries. Fails with one sentence if pieces are missing or it has more than
/// `most` bytes.
[[nodiscard]] Expected<std::vector<std::byte>> readAttachment(const JournalReader& journal, std::string_view name,
                                                              std::size_t most = kMaxAttachmentBytes);

}  // namespace tactooth
