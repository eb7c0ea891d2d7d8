// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/util/byte_stream.h"

namespace tactooth {

/// What is stored of a column in place of its values. Arithmetic is modulo 2^64, so every value comes back.
enum class Differences : std::uint8_t {
    None = 0,    ///< the values
    First = 1,   ///< each value less the one before it: for what changes rarely
    Second = 2,  ///< the differences of these: for what moves evenly, as a hand does within a millisecond
};

/// One quantity over many rows.
struct IntegerColumn {
    Differences differences = Differences::Second;
    std::vector<std::int64_t> values;
};

/// Limits of a table. A table of half a second at 4 kHz has 2,000 rows of some dozen columns.
inline constexpr std::size_t kMaxColumns = 256;
inline constexpr std::size_t kMaxColumnValues = std::size_t{1} << 22;  ///< of all columns together

/// Writes columns of equal length, each as varints of its differences. Columns compress better than rows, because
/// neighbouring bytes mean the same.
void putColumns(ByteWriter& out, std::span<const IntegerColumn> columns);

/// Reads what putColumns wrote. Damage, or a table above the limits, gives no columns, and `in.ok()` is false.
[[nodiscard]] std::vector<IntegerColumn> getColumns(ByteReader& in);

}  // namespace tactooth
