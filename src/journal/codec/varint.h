// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/util/byte_stream.h"

namespace tactooth {

/// Largest number of bytes of a varint: 64 bits in groups of seven.
inline constexpr std::size_t kMaxVarintBytes = 10;

/// Maps numbers near zero to small numbers without a sign: 0, -1, 1, -2, 2 to 0, 1, 2, 3, 4.
[[nodiscard]] constexpr std::uint64_t zigzag(std::int64_t value) {
    return static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
}
[[nodiscard]] constexpr std::int64_t unzigzag(std::uint64_t value) {
    return static_cast<std::int64_t>(value >> 1 ^ (0 - (value & 1)));
}

/// Writes seven bits a byte, the lowest first; the top bit says that more follow (LEB128).
inline void putVarint(ByteWriter& out, std::uint64_t value) {
    while (value >= 0x80) {
        out.put(static_cast<std::uint8_t>(value | 0x80));
        value >>= 7;
    }
    out.put(static_cast<std::uint8_t>(value));
}

/// Reads what putVarint wrote. A number has one encoding: what is longer than it has to be, or than 64 bits, counts as
/// damage (`in.ok()` is then false), and gives 0.
[[nodiscard]] inline std::uint64_t getVarint(ByteReader& in) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < kMaxVarintBytes; ++i) {
        const auto byte = in.get<std::uint8_t>();
        if (!in.ok()) return 0;
        const bool isLast = (byte & 0x80) == 0;
        const bool isTooLong = (i + 1 == kMaxVarintBytes && byte > 1) || (i > 0 && byte == 0);
        if (isTooLong) break;
        value |= std::uint64_t{byte & 0x7FU} << (7 * i);
        if (isLast) return value;
    }
    in.fail();
    return 0;
}

}  // namespace tactooth
