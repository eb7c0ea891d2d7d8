// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace tactooth {

/// CRC-32C of bytes. It finds damage by accident, and does not protect against an attacker. `before`: the CRC of the
/// bytes before these, so that crc32c(b, crc32c(a)) is the CRC of a followed by b.
[[nodiscard]] std::uint32_t crc32c(std::span<const std::byte> bytes, std::uint32_t before = 0);

/// The two ways to compute it; `crc32c` takes the faster one that this processor has.
[[nodiscard]] std::uint32_t crc32cByTables(std::span<const std::byte> bytes, std::uint32_t before = 0);
/// Only where hasCrc32cInstruction() holds.
[[nodiscard]] std::uint32_t crc32cByInstruction(std::span<const std::byte> bytes, std::uint32_t before = 0);
[[nodiscard]] bool hasCrc32cInstruction();

}  // namespace tactooth
