// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/tooth_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "simulation/same_tooth.h"
#include "support/few_teeth.h"
#include "support/mesh_checks.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

using test::expectSame;

const ToothRequest kTooth{41, 1000, 0, {}};

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(ToothCache, GivesBackTheToothBitForBit) {
    const test::TemporaryFolder folder;
    const ToothCache cache(folder / "cache");
    const BuiltinTooth made = cache.make(kTooth);
    EXPECT_TRUE(fs::exists(cache.fileOf(kTooth)));
    expectSame(made, makeTooth(kTooth));
    expectSame(cache.make(kTooth), made);
    ToothRequest decayed = kTooth;
    decayed.lesion = Lesion{LesionSite::Mesial, 1.5, {}};
    expectSame(cache.make(decayed), makeTooth(decayed));
    expectSame(cache.make(decayed), makeTooth(decayed));
}

TEST(ToothCache, SaysHowMuchOfAToothIsMade) {
    std::vector<double> shares;
    ToothRequest decayed = kTooth;
    decayed.lesion = Lesion{LesionSite::Mesial, 1.5, {}};
    const BuiltinTooth made = ToothCache({}).make(decayed, [&](double share) { shares.push_back(share); });
    expectSame(made, makeTooth(decayed));
    EXPECT_GE(shares.size(), 4u);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_GT(shares.front(), 0);
    EXPECT_LT(shares.front(), 0.5);
    EXPECT_EQ(shares.back(), 1);
}

TEST(ToothCache, ReadsTheFileInsteadOfMakingTheTooth) {
    const test::TemporaryFolder folder;
    const ToothCache cache(folder.path());
    ToothRequest other = kTooth;
    other.seed = 9;
    (void)cache.make(other);
    (void)cache.make(kTooth);
    fs::copy_file(cache.fileOf(other), cache.fileOf(kTooth), fs::copy_options::overwrite_existing);
    expectSame(cache.make(kTooth), makeTooth(other));  // a sound file of the same tooth is believed
}

TEST(ToothCache, OtherRequestsHaveOtherFiles) {
    const ToothCache cache("folder");
    ToothRequest seed = kTooth, resolution = kTooth, number = kTooth, decayed = kTooth;
    seed.seed = 1;
    resolution.triangles = 1002;
    number.fdi = 42;
    decayed.lesion = Lesion{};
    for (const ToothRequest& other : {seed, resolution, number, decayed}) {
        EXPECT_NE(cache.fileOf(other), cache.fileOf(kTooth));
    }
    EXPECT_EQ(cache.fileOf(kTooth), cache.fileOf(kTooth));
}

TEST(ToothCache, DamagedFilesAreMadeAnew) {
    const test::TemporaryFolder folder;
    const ToothCache cache(folder.path());
    const BuiltinTooth made = cache.make(kTooth);
    const fs::path file = cache.fileOf(kTooth);
    const auto size = fs::file_size(file);
    for (const std::uintmax_t at : {std::uintmax_t{0}, std::uintmax_t{9}, std::uintmax_t{20}, size / 2, size - 1}) {
        std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekg(static_cast<std::streamoff>(at));
        const char byte = static_cast<char>(stream.get() ^ 0x40);
        stream.seekp(static_cast<std::streamoff>(at));
        stream.put(byte);
        stream.close();
        expectSame(cache.make(kTooth), made);
        EXPECT_EQ(fs::file_size(file), size);
    }
    for (const std::uintmax_t length : {std::uintmax_t{0}, std::uintmax_t{7}, size / 3}) {
        fs::resize_file(file, length);
        expectSame(cache.make(kTooth), made);
        EXPECT_EQ(fs::file_size(file), size);
    }
}

const MouthRequest kMouth{.triangles = 1000, .missing = test::allTeethExcept({16, 11, 33, 35, 46})};

TEST(ToothCache, OtherMouthsHaveOtherFilesButTheOpenOneIsTheClosedOneMoved) {
    const ToothCache cache("folder");
    MouthRequest seed = kMouth, resolution = kMouth, gap = kMouth, twoGaps = kMouth, sameGaps = kMouth, open = kMouth;
    seed.seed = 1;
    resolution.triangles = 1002;
    gap.missing = {46};
    twoGaps.missing = {46, 11};
    sameGaps.missing = {11, 46};
    open.jaw = JawPose::Open;
    for (const MouthRequest& other : {seed, resolution, gap, twoGaps}) {
        EXPECT_NE(cache.fileOf(other), cache.fileOf(kMouth));
    }
    EXPECT_NE(cache.fileOf(gap), cache.fileOf(twoGaps));
    EXPECT_EQ(cache.fileOf(sameGaps), cache.fileOf(twoGaps));
    EXPECT_EQ(cache.fileOf(open), cache.fileOf(kMouth));
}

TEST(ToothCache, KeepsNoMoreThanItsLimitAndForgetsTheOldestFirst) {
    const test::TemporaryFolder folder;
    const auto one = [&] {
        const ToothCache measure(folder / "measure");
        (void)measure.make(kTooth);
        return fs::file_size(measure.fileOf(kTooth));
    }();
    const ToothCache cache(folder / "small", 5 * one / 2);
    std::vector<fs::path> files;
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const ToothRequest request{41, 1000, seed, {}};
        (void)cache.make(request);
        files.push_back(cache.fileOf(request));
        const auto past = fs::file_time_type::clock::now() - std::chrono::hours(10 - seed);
        if (fs::exists(files.back())) fs::last_write_time(files.back(), past);
    }
    EXPECT_FALSE(fs::exists(files[0]));
    EXPECT_FALSE(fs::exists(files[1]));
    EXPECT_TRUE(fs::exists(files[2]));
    EXPECT_TRUE(fs::exists(files[3]));
}

TEST(ToothCache, AFolderThatCannotBeWrittenIsNoReasonToFail) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "file") << "not a folder";
    expectSame(ToothCache(folder / "file").make(kTooth), makeTooth(kTooth));
    expectSame(ToothCache({}).make(kTooth), makeTooth(kTooth));
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(ToothCache, StandsWhereTheUserWantsCaches) {
    const char* const before = std::getenv("XDG_CACHE_HOME");
    const std::string kept = before != nullptr ? before : "";
    setenv("XDG_CACHE_HOME", "/somewhere", 1);
    EXPECT_EQ(defaultCacheFolder(), fs::path("/somewhere/tactooth"));
    setenv("XDG_CACHE_HOME", "relative", 1);
    EXPECT_NE(defaultCacheFolder(), fs::path("relative/tactooth"));
    before != nullptr ? setenv("XDG_CACHE_HOME", kept.c_str(), 1) : unsetenv("XDG_CACHE_HOME");
}

}  // namespace
}  // namespace tactooth
