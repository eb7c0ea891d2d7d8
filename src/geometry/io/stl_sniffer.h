// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace tactooth::stl {

enum class Kind { Binary, Ascii, Neither };

/// Which kind of STL the bytes are. Binary is told by a triangle count that fits the size exactly, since the header
/// of many binary files begins with `solid`; no ASCII file of less than 27 GB can look like that (its count field
/// would hold four printable characters). ASCII begins with `solid` and has no NUL in its beginning.
[[nodiscard]] Kind sniff(std::span<const std::byte> bytes);

}  // namespace tactooth::stl
