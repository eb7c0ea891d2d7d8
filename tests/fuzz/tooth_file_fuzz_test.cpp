// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The fuzz target as an ordinary test: over saved teeth and over seeded mutations of them.
#include <gtest/gtest.h>

#include <random>

#include "fuzz/fuzz_target.h"
#include "support/shapes.h"
#include "tooth/byte_stream.h"
#include "tooth/saved_tooth.h"

namespace tactooth {
namespace {

std::vector<std::byte> savedBlock(bool isCut) {
    std::vector<LayerMesh> layers;
    layers.push_back({"core", MaterialId::Dentin, test::box(Vec3(-0.3, -0.3, -0.8), Vec3(0.3, 0.3, -0.2))});
    auto tooth = LayeredTooth::make(test::box(Vec3(-0.5, -0.5, -1), Vec3(0.5, 0.5, 0)), std::move(layers));
    CutVolume volume(std::make_shared<const LayeredTooth>(std::move(*tooth)), 0.1);
    const auto bur = RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.2, 2, 16));
    MaterialVolumes removed{};
    if (isCut)
        removed = volume.carve(*bur, {Vec3(0, 0, 0.2), Quat::Identity()}, {Vec3(0, 0, -0.3), Quat::Identity()}).removed;
    return savedToothBytes(volume, removed, {{"who", "a test"}});
}

void tryTarget(const std::vector<std::byte>& bytes) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// As the fuzz target does: the checksum fits whatever stands before it.
bool isAcceptedWhenSealed(std::vector<std::byte> bytes) {
    if (bytes.size() < 8) return false;
    const std::uint64_t sum = checksum(std::span(bytes).first(bytes.size() - 8));
    std::memcpy(bytes.data() + bytes.size() - 8, &sum, sizeof sum);
    return parseSavedTooth(bytes, "seed").has_value();
}

TEST(ToothFileFuzz, EverySeedAndEveryBeginningOfItKeepsThePromises) {
    const std::vector<std::byte> seed = savedBlock(true);
    ASSERT_TRUE(parseSavedTooth(seed, "seed"));
    for (std::size_t length = 0; length < std::min<std::size_t>(seed.size(), 1500); ++length) {
        tryTarget({seed.begin(), seed.begin() + static_cast<std::ptrdiff_t>(length)});
    }
}

TEST(ToothFileFuzz, MutatedSeedsKeepThePromises) {
    const std::vector<std::vector<std::byte>> seeds = {savedBlock(false), savedBlock(true)};
    std::mt19937 random(20261121);
    int accepted = 0;
    constexpr int kRounds = 1500;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<std::byte> bytes = seeds[random() % 2];
        for (unsigned change = 0; change <= random() % 3; ++change) {
            // Half of the changes hit the beginning, where sizes and counts stand.
            const std::size_t at = random() % (random() % 2 == 0 ? 600 : bytes.size());
            if (at >= bytes.size()) continue;
            if (random() % 8 == 0) {
                bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
            } else {
                bytes[at] ^= static_cast<std::byte>(1U << random() % 8);
            }
        }
        accepted += isAcceptedWhenSealed(bytes);
        tryTarget(bytes);
    }
    // Neither all refused nor all accepted, or the mutations would try little.
    EXPECT_GT(accepted, kRounds / 20);
    EXPECT_LT(accepted, kRounds * 19 / 20);
}

}  // namespace
}  // namespace tactooth
