// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>

namespace tactooth {

/// BLAKE2b with 256 bits (RFC 7693): nobody can find other bytes with the same digest.
using Digest = std::array<std::byte, 32>;

/// Computes the digest of bytes that come one after the other.
class Digester {
public:
    Digester();
    Digester(Digester&&) noexcept;
    Digester& operator=(Digester&&) noexcept;
    ~Digester();

    void add(std::span<const std::byte> bytes);
    /// Of all bytes so far; more may follow.
    [[nodiscard]] Digest digest() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tactooth
