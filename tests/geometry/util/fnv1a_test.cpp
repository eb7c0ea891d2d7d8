// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/fnv1a.h"

#include <gtest/gtest.h>

#include <random>
#include <string_view>
#include <utility>

#include "geometry/util/byte_text.h"

namespace tactooth {
namespace {

std::uint64_t hashOf(std::string_view text) { return Fnv1a().addBytes(asBytes(text)).value(); }

/// The vectors of Noll's test_fnv.c, which draft-eastlake-fnv repeats.
TEST(Fnv1a, GivesThePublishedTestVectors) {
    const std::pair<std::string_view, std::uint64_t> vectors[] = {
        {"", 0xcbf29ce484222325ULL},      {"a", 0xaf63dc4c8601ec8cULL},      {"b", 0xaf63df4c8601f1a5ULL},
        {"fo", 0x08985907b541d342ULL},    {"foo", 0xdcb27518fed9d577ULL},    {"foob", 0xdd120e790c2512afULL},
        {"fooba", 0xcac165afa2fef40aULL}, {"foobar", 0x85944171f73967e8ULL},
    };
    for (const auto& [text, expected] : vectors) EXPECT_EQ(hashOf(text), expected) << text;
}

TEST(Fnv1a, BytesOfAValueAreItsBytesFromTheLowest) {
    std::mt19937_64 random(20261126);
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t value = random();
        Fnv1a bytes;
        for (int byte = 0; byte < 8; ++byte) bytes.addByte(static_cast<std::byte>(value >> (8 * byte)));
        EXPECT_EQ(Fnv1a().addBytesOf(value).value(), bytes.value());
    }
}

TEST(Fnv1a, AWordOfOneByteIsThatByte) {
    for (unsigned byte = 0; byte < 256; ++byte) {
        EXPECT_EQ(Fnv1a().addWord(byte).value(), Fnv1a().addByte(static_cast<std::byte>(byte)).value());
    }
}

TEST(Fnv1a, PartsGiveTheHashOfTheWhole) {
    EXPECT_EQ(Fnv1a().addBytes(asBytes("foo")).addBytes(asBytes("bar")).value(), hashOf("foobar"));
}

}  // namespace
}  // namespace tactooth
