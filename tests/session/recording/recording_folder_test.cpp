// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/recording_folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>

#include "bench_scene.h"
#include "recording/aged_file.h"
#include "session/recording/kept_recording.h"
#include "session/recording/session_recording.h"
#include "support/scoped_variable.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

TEST(RecordingFolder, IsInTheUsersFolderForData) {
    const test::ScopedVariable home("HOME", "/home/somebody");
    {
        const test::ScopedVariable data("XDG_DATA_HOME", "/data");
        EXPECT_EQ(defaultRecordingFolder(), "/data/tactooth/recordings");
    }
    const test::ScopedVariable relative("XDG_DATA_HOME", "data");
    EXPECT_EQ(defaultRecordingFolder(), "/home/somebody/.local/share/tactooth/recordings");
    const test::ScopedVariable nowhere("HOME", "");
    EXPECT_EQ(defaultRecordingFolder(), "");
}

TEST(RecordingFolder, ANameHasDateTimeAndToothAndNothingThatAFileSystemForbids) {
    const auto now = std::chrono::system_clock::now();
    EXPECT_THAT(recordingName(now, "Lower molar"), MatchesRegex("....-..-.. .....? Lower molar"));
    EXPECT_THAT(recordingName(now, "a/b\\c:d\n\"?"), EndsWith(" a_b_c_d___"));
    EXPECT_THAT(recordingName(now, "../../etc"), ::testing::Not(HasSubstr("/")));
    EXPECT_THAT(recordingName(now, ""), MatchesRegex("....-..-.. ....."));
    std::string longTitle;
    for (int i = 0; i < 100; ++i) longTitle += "歯";  // three bytes each: none is cut apart
    const std::string name = recordingName(now, longTitle);
    EXPECT_LT(name.size(), 110U);
    EXPECT_EQ((name.size() - std::string("2026-11-26 14.32 ").size()) % 3, 0U);
}

TEST(RecordingFolder, ALiveNameHasTheNumberOfTheProcessAndIsFree) {
    const test::TemporaryFolder home;
    const RecordingFolder folder(home / "a/b");
    const auto first = folder.liveName();
    ASSERT_TRUE(first) << first.error().message();
    EXPECT_EQ(first->filename(), "live-" + std::to_string(::getpid()) + "-0.ttsession");
    test::makeFile(*first, 1);
    EXPECT_NE(*folder.liveName(), *first);
}

TEST(RecordingFolder, KeepsUnderAReadableNameAndReplacesNothing) {
    const test::TemporaryFolder home;
    const RecordingFolder folder(home.path());
    const auto now = std::chrono::system_clock::now();
    for (int i = 0; i < 3; ++i) {
        test::makeFile(home / "live-1-0.ttsession", 1 + static_cast<std::size_t>(i));
        const auto kept = folder.keep(home / "live-1-0.ttsession", now, "Molar");
        ASSERT_TRUE(kept) << kept.error().message();
        EXPECT_EQ(fs::file_size(*kept), 1 + static_cast<std::size_t>(i));
    }
    EXPECT_THAT(namesIn(home.path()), ::testing::SizeIs(3));
    EXPECT_FALSE(folder.keep(home / "gone.ttsession", now, "Molar"));
}

TEST(RecordingFolder, TheOldestFinishedRecordingsGoFirstAndNothingElse) {
    const test::TemporaryFolder home;
    const RecordingFolder folder(home.path(), 3000);
    test::makeFile(home / "live-1-0.ttsession", 1000, 9h);               // left by a crash
    test::makeFile(home / "autosave-1-0.tactooth", 500, 9h);             // not restored yet
    test::makeFile(home / "my lesson.ttsession", 500, 9h);               // a name of the user's own
    test::makeFile(home / "2026-11-24 10.00 Molar.ttsession", 900, 8h);  // the oldest
    test::makeFile(home / "2026-11-25 10.00 Molar.ttsession", 900, 7h);
    test::makeFile(home / "2026-11-26 10.00 Molar.ttsession", 900, 6h);
    EXPECT_EQ(folder.bytes(), 4700U);
    folder.tidy();
    EXPECT_THAT(namesIn(home.path()),
                ::testing::ElementsAre("2026-11-26 10.00 Molar.ttsession", "autosave-1-0.tactooth",
                                       "live-1-0.ttsession", "my lesson.ttsession"));
}

TEST(RecordingFolder, NamesWhatHasEndedNewestFirst) {
    const test::TemporaryFolder home;
    test::makeFile(home / "2026-11-24 10.00 Molar.ttsession", 10, 2h);
    test::makeFile(home / "2026-11-26 10.00 Molar.ttsession", 10, 1h);
    test::makeFile(home / "2026-11-25 10.00 Molar.ttsession", 10, 3h);
    test::makeFile(home / "live-1-0.ttsession", 10);
    test::makeFile(home / "my lesson.ttsession", 10);
    EXPECT_THAT(
        RecordingFolder(home.path()).finished(),
        ::testing::ElementsAre(home / "2026-11-26 10.00 Molar.ttsession", home / "2026-11-24 10.00 Molar.ttsession",
                               home / "2026-11-25 10.00 Molar.ttsession"));
    EXPECT_TRUE(RecordingFolder(home / "nothing here").finished().empty());
}

TEST(RecordingFolder, ARecordingThatIsReadOrWrittenIsNotRemoved) {
    const test::TemporaryFolder home;
    const fs::path file = home / "2026-11-24 10.00 Molar.ttsession";
    test::makeFile(file, 900);
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(::flock(descriptor, LOCK_EX), 0);
    RecordingFolder(home.path(), 0).tidy();
    EXPECT_TRUE(fs::exists(file));
    ::close(descriptor);
    RecordingFolder(home.path(), 0).tidy();
    EXPECT_FALSE(fs::exists(file));
}

TEST(RecordingFolder, OffersWhatNobodyWritesOnceAndNewestFirst) {
    const test::TemporaryFolder home;
    const RecordingFolder folder(home.path());
    test::makeFile(home / "live-1-0.ttsession", 10, 2h);
    test::makeFile(home / "autosave-1-0.tactooth", 10, 1h);
    test::makeFile(home / "live-2-0.ttsession", 10);
    test::makeFile(home / "2026-11-24 10.00 Molar.ttsession", 10);
    const int running = ::open((home / "live-2-0.ttsession").c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(::flock(running, LOCK_EX), 0);  // as its writer does
    {
        const std::vector<Leftover> found = folder.leftovers();
        ASSERT_EQ(found.size(), 2U);
        EXPECT_EQ(found[0].kind(), Leftover::Kind::Tooth);
        EXPECT_EQ(found[1].kind(), Leftover::Kind::Recording);
        EXPECT_TRUE(folder.leftovers().empty()) << "another window does not offer them too";
    }
    ::close(running);
    EXPECT_EQ(folder.leftovers().size(), 3U);
}

TEST(RecordingFolder, AFolderThatCannotBeMadeHasItsSentence) {
    const test::TemporaryFolder home;
    test::makeFile(home / "file", 1);
    const auto name = RecordingFolder(home / "file/recordings").liveName();
    ASSERT_FALSE(name);
    EXPECT_THAT(name.error().message(), HasSubstr("this session is not recorded"));
    EXPECT_TRUE(RecordingFolder(home / "nowhere").leftovers().empty());
    EXPECT_EQ(RecordingFolder(home / "nowhere").bytes(), 0U);
}

TEST(KeptRecording, IsKeptUnderItsNameIfSomethingWasTouched) {
    const test::TemporaryFolder home;
    const RecordingFolder folder(home.path());
    const auto tooth = test::blockOnTheBench();
    auto recording = KeptRecording::begin(folder, tooth, "Block", R"({"title":"Block","seconds":4,"events":[]})");
    ASSERT_TRUE(recording) << recording.error().message();
    EXPECT_THAT(namesIn(home.path()), ::testing::ElementsAre(StartsWith("live-")));
    EXPECT_TRUE(folder.leftovers().empty()) << "it is being written";
    (*recording)->noteTouch();
    const auto done = (*recording)->finish();
    ASSERT_TRUE(done) << done.error().message();
    ASSERT_THAT(namesIn(home.path()), ::testing::ElementsAre(EndsWith(" Block.ttsession")));
    const auto read = SessionRecording::open(home / namesIn(home.path()).front());
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_TRUE(read->journal().isComplete());
    ASSERT_TRUE(read->work());
    EXPECT_EQ(read->work()->title, "Block");
    EXPECT_EQ(read->work()->seconds, 4);
    EXPECT_FALSE(*read->hasChanges());
}

TEST(KeptRecording, IsRemovedIfNothingWasTouched) {
    const test::TemporaryFolder home;
    const auto tooth = test::blockOnTheBench();
    auto recording = KeptRecording::begin(RecordingFolder(home.path()), tooth, "Block", "{}");
    ASSERT_TRUE(recording) << recording.error().message();
    EXPECT_TRUE((*recording)->finish());
    EXPECT_TRUE(namesIn(home.path()).empty());
    recording = KeptRecording::begin(RecordingFolder(home.path()), tooth, "Block", "{}");
    ASSERT_TRUE(recording) << recording.error().message();
    recording->reset();  // given up
    EXPECT_TRUE(namesIn(home.path()).empty());
}

/// A window that stands still while somebody cuts sees no touch.
TEST(KeptRecording, IsKeptIfSomethingWasCutUnseen) {
    const test::TemporaryFolder home;
    const auto tooth = test::blockOnTheBench();
    auto recording = KeptRecording::begin(RecordingFolder(home.path()), tooth, "Block", "{}");
    ASSERT_TRUE(recording) << recording.error().message();
    tooth->sweep(test::flatBur().cutting, test::at(0, 0, 0.2), test::at(0, 0, -0.6));
    (*recording)->recorder().append(CarveEvent{.tick = 1, .published = true});
    EXPECT_TRUE((*recording)->finish());
    EXPECT_THAT(namesIn(home.path()), ::testing::ElementsAre(EndsWith(" Block.ttsession")));
}

TEST(KeptRecording, AFullDiskIsSaidAndWhatWasWrittenIsKept) {
    const test::TemporaryFolder home;
    const auto tooth = test::blockOnTheBench();
    struct rlimit before {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit few = before;
    few.rlim_cur = 16'384;  // bytes: the header and the tooth, but not the text
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &few), 0);
    std::mt19937 random(5);
    std::string text;  // that no compression makes shorter than the limit
    while (text.size() < 100'000) text += static_cast<char>('0' + random() % 64);
    auto recording = KeptRecording::begin(RecordingFolder(home.path()), tooth, "Block", text);
    Expected<void> done;
    if (recording) {
        (*recording)->noteTouch();
        done = (*recording)->finish();
    }
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    const std::string sentence = recording ? (done ? "" : done.error().message()) : recording.error().message();
    EXPECT_FALSE(sentence.empty());
    EXPECT_THAT(sentence, HasSubstr(home.path().filename().string()));
    const std::vector<std::string> left = namesIn(home.path());
    ASSERT_EQ(left.size(), 1U);
    EXPECT_TRUE(SessionRecording::open(home / left.front())) << "what came before is kept";
}

}  // namespace
}  // namespace tactooth
