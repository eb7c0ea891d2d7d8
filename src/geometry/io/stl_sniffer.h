// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace tactooth::stl {

enum class Kind { Binary, Ascii, Neither };

/// The kind of STL that the bytes are. Binary STL has a triangle count that fits the size exactly, since the header of
/// many binary files begins with `solid`. No ASCII file of less than 27 GB can look like that, because its count field
/// would hold four printable characters. ASCII STL begins with `solid` and has no NUL near its start.
[[nodiscard]] Kind sniff(std::span<const std::byte> bytes);

}  // namespace tactooth::stl
