// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Recordings that one build has made replay to the same bits in each other one: any compiler, Debug or Release, with or
// without vector instructions, on any number of threads.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>

#include "scripted_session.h"
#include "second_hashes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::ScriptedSession;
using test::SecondHash;

std::vector<ScriptedSession> sessions() {
    return {{.name = "ball-coarse",
             .seed = 46,
             .parts = {{"4", Freedom::Translation, 1.5}, {"2", Freedom::TranslationAndRotation, 2.5}},
             .changes = {{0.9, Edit::Undo}, {0.95, Edit::Redo}, {1.2, Edit::Reset}, {2.2, Edit::Undo}},
             .hasMirror = true},
            {.name = "taper-25um",
             .tooth = BuiltinToothKind::UpperCentralIncisor,
             .voxel = 0.025,
             .seed = 25,
             .parts = {{"169", Freedom::TranslationAndRotation, 1.2}, {"330", Freedom::Translation, 2}},
             .changes = {{0.8, Edit::Undo}, {0.85, Edit::Redo}, {1.1, Edit::Reset}, {1.8, Edit::Undo}}}};
}

std::filesystem::path fileOf(const std::string& name) { return test::sourceFolder() / "tests/golden/data" / name; }

class Recordings : public ::testing::TestWithParam<ScriptedSession> {};

TEST_P(Recordings, ReplayToTheSameBitsInEveryBuildOnAnyNumberOfThreads) {
    const std::string& name = GetParam().name;
    const auto recording = fileOf(name + ".ttsession"), hashes = fileOf(name + ".hashes");
    if (std::getenv("TACTOOTH_UPDATE_RECORDINGS") != nullptr) {
        std::filesystem::remove(recording);  // a recording replaces none
        ASSERT_NO_FATAL_FAILURE(GetParam().writeTo(recording));
        test::writeHashes(hashes, test::replayedHashes(recording));
        GTEST_SKIP() << "renewed " << recording;
    }
    const std::vector<SecondHash> recorded = test::readHashes(hashes);
    ASSERT_GE(recorded.size(), 2U);
    EXPECT_EQ(test::differenceOf(recorded, test::replayedHashes(recording), name), "");
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(test::differenceOf(recorded, test::replayedHashes(recording), name + " on one thread"), "");
}

INSTANTIATE_TEST_SUITE_P(Golden, Recordings, ::testing::ValuesIn(sessions()), [](const auto& session) {
    std::string name = session.param.name;
    std::erase(name, '-');
    return name;
});

TEST(SecondHashes, ADifferenceNamesItsSecond) {
    const std::vector<SecondHash> recorded = {{1, "a", "1"}, {2, "b", "2"}, {3, "c", "3"}};
    EXPECT_EQ(test::differenceOf(recorded, recorded, "x"), "");
    std::vector<SecondHash> other = recorded;
    other[1].volume = "d";
    EXPECT_TRUE(test::differenceOf(recorded, other, "x").starts_with("Second 2 of x differs in its tooth; "));
    other = recorded;
    other[2].ticks = "4";
    EXPECT_TRUE(test::differenceOf(recorded, other, "x").starts_with("Second 3 of x differs in its forces; "));
    other.pop_back();
    EXPECT_TRUE(test::differenceOf(recorded, other, "x").starts_with("Second 3 of x differs in its tooth; "))
        << "the replay found itself that it differs, and ended";
}

}  // namespace
}  // namespace tactooth
