// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

// G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake, "The FNV Non-Cryptographic Hash Algorithm", IETF draft-eastlake-fnv:
// FNV-1a with 64 bits. `addWord` is ours: one step for a whole word is faster, and gives other values than the
// published hash of its bytes.

namespace tactooth {

/// FNV-1a hash of 64 bits, to detect a difference by accident. It does not protect against an attacker. It allocates
/// nothing.
class Fnv1a {
public:
    constexpr Fnv1a& addByte(std::byte byte) { return step(static_cast<std::uint64_t>(byte)); }

    constexpr Fnv1a& addBytes(std::span<const std::byte> bytes) {
        for (const std::byte byte : bytes) addByte(byte);
        return *this;
    }

    /// The eight bytes of `value`, the lowest first: the same on each machine.
    constexpr Fnv1a& addBytesOf(std::uint64_t value) {
        for (int byte = 0; byte < 8; ++byte) step(value >> (8 * byte) & 0xFF);
        return *this;
    }

    /// `word` in a single step. Use it alone, or never, in one hash: it is not the same as its bytes.
    constexpr Fnv1a& addWord(std::uint64_t word) { return step(word); }

    [[nodiscard]] constexpr std::uint64_t value() const { return hash_; }

private:
    constexpr Fnv1a& step(std::uint64_t value) {
        constexpr std::uint64_t kPrime = 0x100000001b3ULL;
        hash_ = (hash_ ^ value) * kPrime;
        return *this;
    }

    std::uint64_t hash_ = 0xcbf29ce484222325ULL;  // the offset basis
};

}  // namespace tactooth
