// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "journal/format/journal_block.h"

namespace tactooth {

/// Bytes of a file in one block.
inline constexpr std::size_t kAttachmentPieceBytes = std::size_t{4} << 20;
inline constexpr std::size_t kMaxAttachmentName = 256;  ///< bytes

/// Cuts a file into blocks. `name` is how the session finds it again, as by the hash of its content; UTF-8.
[[nodiscard]] std::vector<JournalBlock> attachmentBlocks(std::string_view name, std::span<const std::byte> content);

/// A piece of a file, from the payload of a block.
struct AttachmentPiece {
    std::string name;
    std::uint64_t totalBytes = 0;  ///< of the whole file
    std::uint64_t offset = 0;      ///< of this piece in it
    std::span<const std::byte> content;
};
/// Nothing for a payload of another form. `content` is a part of `payload`.
[[nodiscard]] std::optional<AttachmentPiece> parseAttachment(std::span<const std::byte> payload);

}  // namespace tactooth
