// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <vector>

#include "session/simulation/tooth_cache.h"
#include "simulation/same_tooth.h"
#include "support/few_teeth.h"
#include "support/mesh_checks.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

const MouthRequest kMouth{.triangles = 1000, .missing = test::allTeethExcept({16, 11, 33, 35, 46})};

void expectSame(const BuiltinMouth& a, const BuiltinMouth& b) {
    EXPECT_TRUE(test::areBitEqual(a.upperGingiva, b.upperGingiva));
    EXPECT_TRUE(test::areBitEqual(a.lowerGingiva, b.lowerGingiva));
    ASSERT_EQ(a.teeth.size(), b.teeth.size());
    for (std::size_t i = 0; i < a.teeth.size(); ++i) {
        test::expectSame(a.teeth[i].tooth, b.teeth[i].tooth);
        EXPECT_EQ(a.teeth[i].toothInMouth.position, b.teeth[i].toothInMouth.position);
        EXPECT_EQ(a.teeth[i].toothInMouth.rotation.coeffs(), b.teeth[i].toothInMouth.rotation.coeffs());
    }
}

TEST(MouthCache, GivesBackAMouthBitForBitMakesADamagedOneAnewAndReadsItsGums) {
    const test::TemporaryFolder folder;
    const ToothCache cache(folder.path());
    std::mutex mutex;
    std::vector<double> shares;
    const BuiltinMouth made = *cache.makeMouth(kMouth, [&](double share) {
        const std::lock_guard lock(mutex);
        shares.push_back(share);
    });
    std::ranges::sort(shares);
    EXPECT_GT(shares.size(), 10U) << "the user sees how it goes on";
    EXPECT_GT(shares.front(), 0);
    EXPECT_EQ(shares.back(), 1);
    const fs::path file = cache.fileOf(kMouth);
    ASSERT_TRUE(fs::exists(file));
    const auto size = fs::file_size(file);
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(9));
    expectSame(*cache.makeMouth(kMouth), made);
    EXPECT_GT(fs::last_write_time(file), fs::file_time_type::clock::now() - std::chrono::hours(1));
    fs::resize_file(file, size - 1);
    expectSame(*cache.makeMouth(kMouth), *makeMouth(kMouth));
    EXPECT_EQ(fs::file_size(file), size);

    MouthRequest gap = kMouth;
    gap.missing.push_back(46);
    fs::copy_file(file, cache.fileOf(gap));
    const BuiltinMouth read = *cache.makeMouth(gap);
    EXPECT_EQ(read.find(46), nullptr);
    EXPECT_TRUE(test::areBitEqual(read.lowerGingiva, made.lowerGingiva));
}

}  // namespace
}  // namespace tactooth
