// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <span>
#include <string>

namespace tactooth::test {

/// A number in 0..limit-1; 0 for an empty range.
[[nodiscard]] std::size_t below(std::mt19937& random, std::size_t limit);

/// Damages a file's bytes once, its head more often than the rest: changes a byte, flips a bit, cuts, repeats, inserts
/// words of a hostile head or text, or inserts a part of another file.
void mutate(std::string& bytes, std::span<const std::string> others, std::mt19937& random);

}  // namespace tactooth::test
