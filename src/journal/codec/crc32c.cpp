// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/crc32c.h"

#if defined(__x86_64__) && !defined(TACTOOTH_SIMD_SCALAR)
#define TACTOOTH_CRC32C_INSTRUCTION
#include <nmmintrin.h>
#endif

#include <array>
#include <bit>
#include <cstring>

#include "geometry/util/assert.h"

// The polynomial: G. Castagnoli, S. Braeuer, M. Herrmann, "Optimization of Cyclic Redundancy-Check Codes with 24 and 32
// Parity Bits", IEEE Transactions on Communications 41(6), 1993; bit order and test values: RFC 3720, appendix B.4.
// Eight tables: M. E. Kounavis, F. L. Berry, "A Systematic Approach to Building High Performance Software-Based CRC
// Generators", IEEE Symposium on Computers and Communications, 2005.

namespace tactooth {
namespace {

static_assert(std::endian::native == std::endian::little, "eight bytes are read as one word");

constexpr std::uint32_t kPolynomial = 0x82F63B78;  // 0x1EDC6F41 with its bits reversed
constexpr std::size_t kWord = sizeof(std::uint64_t);

using Table = std::array<std::uint32_t, 256>;

/// Table k: the CRC of a byte that k zero bytes follow.
constexpr std::array<Table, kWord> makeTables() {
    std::array<Table, kWord> tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? kPolynomial : 0);
        tables[0][byte] = crc;
    }
    for (std::size_t k = 1; k < kWord; ++k) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t shorter = tables[k - 1][byte];
            tables[k][byte] = shorter >> 8 ^ tables[0][shorter & 0xFF];
        }
    }
    return tables;
}

constexpr std::array<Table, kWord> kTables = makeTables();
static_assert(kTables[0][1] == 0xF26B8303, "as in RFC 3720");

std::uint64_t wordAt(const std::byte* place) {
    std::uint64_t word = 0;
    std::memcpy(&word, place, kWord);
    return word;
}

}  // namespace

std::uint32_t crc32cByTables(std::span<const std::byte> bytes, std::uint32_t before) {
    std::uint32_t crc = ~before;
    const std::byte* at = bytes.data();
    const std::byte* const end = at + bytes.size();
    for (; static_cast<std::size_t>(end - at) >= kWord; at += kWord) {
        const std::uint64_t word = wordAt(at) ^ crc;
        crc = 0;
        for (std::size_t k = 0; k < kWord; ++k) crc ^= kTables[kWord - 1 - k][word >> (8 * k) & 0xFF];
    }
    for (; at != end; ++at) crc = crc >> 8 ^ kTables[0][(crc ^ static_cast<std::uint32_t>(*at)) & 0xFF];
    return ~crc;
}

#if defined(TACTOOTH_CRC32C_INSTRUCTION)

bool hasCrc32cInstruction() { return __builtin_cpu_supports("sse4.2") != 0; }

__attribute__((target("sse4.2"))) std::uint32_t crc32cByInstruction(std::span<const std::byte> bytes,
                                                                    std::uint32_t before) {
    TACTOOTH_ASSERT(hasCrc32cInstruction());
    std::uint64_t crc = ~before;
    const std::byte* at = bytes.data();
    const std::byte* const end = at + bytes.size();
    for (; static_cast<std::size_t>(end - at) >= kWord; at += kWord) crc = _mm_crc32_u64(crc, wordAt(at));
    auto narrow = static_cast<std::uint32_t>(crc);
    for (; at != end; ++at) narrow = _mm_crc32_u8(narrow, static_cast<std::uint8_t>(*at));
    return ~narrow;
}

#else

bool hasCrc32cInstruction() { return false; }

std::uint32_t crc32cByInstruction(std::span<const std::byte> bytes, std::uint32_t before) {
    TACTOOTH_ASSERT(hasCrc32cInstruction());
    return crc32cByTables(bytes, before);
}

#endif

std::uint32_t crc32c(std::span<const std::byte> bytes, std::uint32_t before) {
    static const bool hasInstruction = hasCrc32cInstruction();
    return hasInstruction ? crc32cByInstruction(bytes, before) : crc32cByTables(bytes, before);
}

}  // namespace tactooth
