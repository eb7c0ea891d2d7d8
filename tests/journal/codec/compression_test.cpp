// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/compression.h"

#include <gtest/gtest.h>

#include <random>

namespace tactooth {
namespace {

using Bytes = std::vector<std::byte>;

Bytes repetitive(std::mt19937& random, std::size_t size) {
    Bytes bytes(size);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random() % 4);
    return bytes;
}

TEST(Compression, UnpacksToTheSameBytes) {
    std::mt19937 random(5);
    Compressor compressor;
    for (const std::size_t size : {500U, 1000U, 65536U, 300000U, 5000000U}) {
        const Bytes raw = repetitive(random, size);
        const auto frame = compressor.compress(raw);
        ASSERT_TRUE(frame) << size;
        EXPECT_LT(frame->size(), raw.size() / 2);
        EXPECT_EQ(decompress(*frame, size), raw);
    }
}

TEST(Compression, GivesNothingThatIsNotSmaller) {
    std::mt19937 random(6);
    Compressor compressor;
    Bytes noise(1000);
    for (std::byte& byte : noise) byte = static_cast<std::byte>(random());
    EXPECT_FALSE(compressor.compress(noise));
    EXPECT_FALSE(compressor.compress({}));
    EXPECT_FALSE(compressor.compress(Bytes(1)));
}

TEST(Compression, RefusesAnotherSizeThanTheFrameStates) {
    Compressor compressor;
    const auto frame = compressor.compress(Bytes(1000, std::byte{7}));
    ASSERT_TRUE(frame);
    for (const std::size_t size : {0U, 999U, 1001U, 1U << 30}) EXPECT_FALSE(decompress(*frame, size)) << size;
}

TEST(Compression, RefusesWhatIsCutOffOrFollowedBySomething) {
    std::mt19937 random(7);
    Compressor compressor;
    const Bytes raw = repetitive(random, 2000);
    const auto frame = compressor.compress(raw);
    ASSERT_TRUE(frame);
    for (std::size_t size = 0; size < frame->size(); ++size)
        EXPECT_FALSE(decompress(std::span(*frame).first(size), raw.size())) << size;
    Bytes longer = *frame;
    longer.push_back(std::byte{0});
    EXPECT_FALSE(decompress(longer, raw.size()));
    longer.pop_back();
    longer.insert(longer.end(), frame->begin(), frame->end());
    EXPECT_FALSE(decompress(longer, raw.size()));
    EXPECT_FALSE(decompress(longer, 2 * raw.size()));
}

TEST(Compression, SurvivesDamage) {
    std::mt19937 random(8);
    Compressor compressor;
    const Bytes raw = repetitive(random, 3000);
    const auto frame = compressor.compress(raw);
    ASSERT_TRUE(frame);
    for (int round = 0; round < 20000; ++round) {
        Bytes damaged = *frame;
        for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = static_cast<std::byte>(random());
        const auto unpacked = decompress(damaged, raw.size());
        if (unpacked) {
            EXPECT_EQ(unpacked->size(), raw.size());
        }
    }
}

}  // namespace
}  // namespace tactooth
