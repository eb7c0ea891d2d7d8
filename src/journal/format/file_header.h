// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tactooth {

/// The first bytes of a recording. As in PNG files, a byte above 127, both line ends and the end-of-file mark of DOS
/// reveal a copy that was made as text.
inline constexpr std::array<std::uint8_t, 8> kJournalMagic = {0x89, 'T', 'T', 'S', '\r', '\n', 0x1A, '\n'};

/// The bytes of a file before its first block: magic, version, length, JSON text, CRC-32C of all that.
[[nodiscard]] std::vector<std::byte> fileHeaderBytes(std::string_view json);

/// The CRC-32C at the end of `fileHeaderBytes`, which the first block is chained to.
[[nodiscard]] std::uint32_t fileHeaderCrc(std::span<const std::byte> header);

/// Bytes around the JSON text.
inline constexpr std::size_t kHeaderFrameBytes = kJournalMagic.size() + 3 * sizeof(std::uint32_t);
/// Bytes before the JSON text: all that is needed to know whether it can be read.
inline constexpr std::size_t kHeaderStartBytes = kHeaderFrameBytes - sizeof(std::uint32_t);

/// What the beginning of a file says.
struct HeaderStart {
    enum class Kind { Valid, NoJournal, OtherVersion, Damaged };
    Kind kind = Kind::NoJournal;
    std::uint32_t version = 0;
    std::uint32_t jsonBytes = 0;
};
/// `start`: the first kHeaderStartBytes of the file, or the whole file if it is shorter.
[[nodiscard]] HeaderStart parseHeaderStart(std::span<const std::byte> start);

}  // namespace tactooth
