// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// kill -9 at random moments of five kinds of work: recording, saving, exporting, autosave and restoring. Whatever was
// written opens, replays, and lacks no more than it may. TACTOOTH_KILLS sets the number of kills of each kind; 10 are
// usual.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>
#include <string_view>
#include <thread>

#include "bench_scene.h"
#include "geometry/files/temporary_file.h"
#include "geometry/io/stl_writer.h"
#include "session/model/session_restore.h"
#include "session/recording/kept_recording.h"
#include "session/recording/session_recording.h"
#include "session/recording/session_replay.h"
#include "session/simulation/tooth_file.h"
#include "support/disk_watch.h"
#include "support/test_data.h"
#include "support/text_file.h"
#include "track/stepped_session.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

constexpr double kMostLost = 1.5;  // s: a block of half a second, and a sync; more where the disk takes longer
constexpr const char* kWork = R"({"title":"Block","bur":"Flat","seconds":1,"events":[]})";
constexpr const char* kLive = "--live";  // KIND FOLDER: the program is the one that is killed

/// What the killed program has done, in memory that outlives it.
struct Progress {
    std::atomic<std::uint64_t> ticks{0};  ///< of the session that is recorded
    std::atomic<std::uint64_t> turns{0};  ///< files written, or steps of a restoration
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

class SharedProgress {
public:
    explicit SharedProgress(const fs::path& folder) {
        const int file = ::open((folder / "progress").c_str(), O_RDWR | O_CREAT, 0600);
        if (file < 0 || ::ftruncate(file, sizeof(Progress)) != 0) std::abort();
        void* const place = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        ::close(file);
        if (place == MAP_FAILED) std::abort();
        progress_ = static_cast<Progress*>(place);  // all zero in a new file
    }
    ~SharedProgress() { ::munmap(progress_, sizeof(Progress)); }
    SharedProgress(const SharedProgress&) = delete;
    SharedProgress& operator=(const SharedProgress&) = delete;

    [[nodiscard]] Progress& operator*() const { return *progress_; }

private:
    Progress* progress_;
};

/// A program that cannot go on ends by itself, and the test sees that.
template <class T>
T must(Expected<T> result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().message().c_str());
        std::_Exit(3);
    }
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

OperatorInput cutting(std::uint64_t tick) {
    const double t = 1e-3 * static_cast<double>(tick);
    const Vec3 tip(1.1 * std::cos(3 * t), 1.1 * std::sin(2 * t), 0.2 - 0.6 * std::abs(std::sin(t)));
    return {{tip, Quat::Identity()}, 1, true};
}

/// Cuts the block for so many seconds of the session, a millisecond each millisecond.
void work(const std::shared_ptr<CutModel>& block, SessionRecorder& recorder, double seconds, Progress& progress) {
    const HapticSettings settings;
    const auto lanes = recorder.begin({test::flatBur(), settings});
    test::SteppedSession session(block, test::flatBur(), settings, lanes);
    const Clock::time_point began = Clock::now();
    while (static_cast<double>(session.ticks()) < 1000 * seconds) {
        session.step(cutting(session.ticks()));
        progress.ticks = session.ticks();
        std::this_thread::sleep_until(began + std::chrono::milliseconds(session.ticks()));  // the hand's own pace
    }
    recorder.end();
}

/// Two states of one tooth, which are written in turn.
std::array<std::shared_ptr<CutModel>, 2> twoTeeth() {
    const auto before = test::cutBlock(), after = test::cutBlock();
    after->sweep(test::flatBur().cutting, test::at(0.5, 0.3, -0.5), test::at(-0.8, -0.4, -0.9));
    after->refreshSurface();
    return {before, after};
}

void liveRecording(const fs::path& folder, Progress& progress) {
    const auto block = test::blockOnTheBench();
    const auto recorder = must(SessionRecorder::create(folder / "s.ttsession", *block, "Block"));
    work(block, *recorder, 60, progress);
}

void liveSaving(const fs::path& folder, Progress& progress) {
    const auto teeth = twoTeeth();
    for (std::uint64_t i = 0;; ++i, progress.turns = i) must(saveTooth(*teeth[i % 2], {}, folder / "t.tactooth"));
}

void liveExporting(const fs::path& folder, Progress& progress) {
    const auto teeth = twoTeeth();
    for (std::uint64_t i = 0;; ++i, progress.turns = i) must(writeStl(teeth[i % 2]->exported().mesh, folder / "t.stl"));
}

/// Short sessions that are kept, as the window keeps them, each with a tooth as at the end by a signal.
void liveAutosave(const fs::path& folder, Progress& progress) {
    const RecordingFolder recordings(folder);
    for (std::uint64_t i = 0;; ++i, progress.turns = i) {
        const auto block = test::blockOnTheBench();
        const auto kept = must(KeptRecording::begin(recordings, block, "Block", kWork));
        kept->noteTouch();
        work(block, kept->recorder(), 0.3, progress);
        must(saveTooth(*block, {}, must(recordings.autosaveName())));
        must(kept->finish());
    }
}

/// Brings back what is in the folder, as the window does, and ends.
void liveRestore(const fs::path& folder, Progress& progress) {
    const RecordingFolder recordings(folder);
    for (const Leftover& leftover : recordings.leftovers()) {
        if (!examine(leftover, recordings)) continue;
        progress.turns = 1;
        RestoreProgress restoring;
        const SessionTooth tooth = must(restoreSession(leftover, restoring));
        progress.turns = 2;
        const auto kept = must(KeptRecording::begin(recordings, tooth.piece, "Block", kWork));
        progress.turns = 3;
        must(recordings.keep(leftover.file(), leftover.time(), "Block"));
        progress.turns = 4;
    }
}

struct Kind {
    const char* name;
    void (*live)(const fs::path& folder, Progress& progress);
    double seconds;  ///< the kill comes within this time after the beginning
};
constexpr std::array kKinds = {Kind{"recording", liveRecording, 4}, Kind{"saving", liveSaving, 1},
                               Kind{"exporting", liveExporting, 1}, Kind{"autosave", liveAutosave, 1.5},
                               Kind{"restore", liveRestore, 0}};

const Kind* findKind(std::string_view name) {
    const auto* const found = std::ranges::find(kKinds, name, &Kind::name);
    return found == kKinds.end() ? nullptr : found;
}

int kills() {
    const char* const wanted = std::getenv("TACTOOTH_KILLS");
    return wanted != nullptr ? std::atoi(wanted) : 10;
}

/// Runs this program as one that lives in `folder`. It is a new process: threads do not survive a fork.
pid_t begin(const char* kind, const fs::path& folder) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    ::execl("/proc/self/exe", "killed_session_tests", kLive, kind, folder.c_str(), nullptr);
    std::_Exit(4);
}

struct Replayed {
    double seconds = 0;
    std::uint64_t ticks = 0;
    std::uint64_t hash = 0;
};

/// It opens and, if there is a tick in it, replays as it was recorded.
Replayed replayed(const fs::path& file) {
    SCOPED_TRACE(file.filename().string());
    const auto recording = SessionRecording::open(file);
    EXPECT_TRUE(recording) << recording.error().message();
    if (!recording) return {};
    const auto seconds = recording->seconds();
    EXPECT_TRUE(seconds) << seconds.error().message();
    if (!seconds || *seconds == 0) return {};
    auto replay = SessionReplay::start(*recording);
    EXPECT_TRUE(replay) << replay.error().message();
    if (!replay) return {};
    const auto played = replay->playUntil({}, {});
    EXPECT_TRUE(played) << played.error().message();
    EXPECT_FALSE(replay->differsAt());
    return {*seconds, replay->ticks(), replay->model().hash()};
}

bool hasBegun(const Progress& progress) { return progress.ticks > 0 || progress.turns > 0; }

/// Waits for the end of a child, so many seconds at most. It stays to be waited for.
bool endsWithin(pid_t child, double seconds) {
    const int watched = static_cast<int>(::syscall(SYS_pidfd_open, child, 0));
    if (watched < 0) std::abort();
    pollfd end{.fd = watched, .events = POLLIN, .revents = 0};
    const auto most = std::chrono::duration_cast<std::chrono::nanoseconds>(Seconds(seconds)).count();
    const timespec patience{.tv_sec = most / 1'000'000'000, .tv_nsec = most % 1'000'000'000};
    const bool hasEnded = ::ppoll(&end, 1, &patience, nullptr) > 0;
    ::close(watched);
    return hasEnded;
}

class KilledSession : public ::testing::Test {
protected:
    /// Kills one life after `delay`, or after `delay` at work, and waits until it is gone. False if it had ended
    /// before.
    static bool killAfter(const char* kind, const fs::path& folder, double delay, const Progress* atWork) {
        const pid_t child = begin(kind, folder);
        while (atWork != nullptr && !hasBegun(*atWork) && !endsWithin(child, 1e-3)) {
        }
        (void)endsWithin(child, delay);
        ::kill(child, SIGKILL);
        int status = 0;
        EXPECT_EQ(::waitpid(child, &status, 0), child);
        if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGKILL;
        EXPECT_EQ(WEXITSTATUS(status), 0);
        return false;
    }
    /// Kills a recording as soon as its session has so many ticks.
    static void killAtTick(std::uint64_t ticks, const fs::path& folder, const Progress& progress) {
        const pid_t child = begin("recording", folder);
        while (progress.ticks < ticks && !endsWithin(child, 1e-3)) {
        }
        ::kill(child, SIGKILL);
        int status = 0;
        EXPECT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
    }
    /// Calls `check(folder, progress)` after each kill, and counts those that came after something was done. `prepare`
    /// is called with each new folder.
    template <class Prepare, class Check>
    void killEach(const char* kind, double within, const Prepare& prepare, const Check& check) {
        std::mt19937 random(300);
        int killed = 0, atWork = 0;
        for (int tried = 0; killed < kills() && tried < 20 * kills() && !HasFailure(); ++tried) {
            const test::TemporaryFolder folder;
            const SharedProgress progress(folder.path());
            prepare(folder.path());
            const double delay = std::uniform_real_distribution(0.0, within)(random);
            SCOPED_TRACE(std::string(kind) + ", killed after " + std::to_string(delay) + " s");
            // Each other one is at work, however long a busy machine takes to begin.
            if (!killAfter(kind, folder.path(), delay, tried % 2 == 0 ? &*progress : nullptr)) continue;
            ++killed;
            atWork += hasBegun(*progress) ? 1 : 0;
            check(folder.path(), *progress);
        }
        EXPECT_EQ(killed, kills());
        EXPECT_GT(atWork, kills() / 4) << "the kills came too early";
        std::printf("%s: %d kills, %d of them at work\n", kind, killed, atWork);
    }
    /// No name but those that are expected, and those of unfinished files that nobody takes for others.
    static void expectNoHalfFile(const fs::path& folder, const std::vector<std::string>& endings) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            const bool isKnown = name == "progress" || isRandomName(name) ||
                                 std::ranges::any_of(endings, [&](const auto& end) { return name.ends_with(end); });
            EXPECT_TRUE(isKnown) << name;
        }
    }
    static std::vector<fs::path> filesOf(const fs::path& folder, std::string_view ending) {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            if (name.ends_with(ending) && !isRandomName(name)) files.push_back(entry.path());
        }
        return files;
    }
    static void nothing(const fs::path&) {}
};

TEST_F(KilledSession, WhileItIsRecordedLacksNoMoreThanItMay) {
    double mostLost = 0;
    test::DiskWatch disk;
    killEach("recording", findKind("recording")->seconds, nothing, [&](const fs::path& folder, Progress& progress) {
        expectNoHalfFile(folder, {".ttsession"});
        const double lived = 1e-3 * static_cast<double>(progress.ticks);
        double recorded = 0;
        for (const fs::path& file : filesOf(folder, ".ttsession")) recorded = replayed(file).seconds;
        EXPECT_LT(lived - recorded, kMostLost + disk.takeLongest());
        mostLost = std::max(mostLost, lived - recorded);
    });
    std::printf("recording: at most %.2f s lost\n", mostLost);
}

TEST_F(KilledSession, WhileItIsSavedLeavesAWholeTooth) {
    const auto teeth = twoTeeth();
    ASSERT_NE(teeth[0]->hash(), teeth[1]->hash());
    killEach("saving", findKind("saving")->seconds, nothing, [&](const fs::path& folder, Progress& progress) {
        expectNoHalfFile(folder, {".tactooth"});
        const auto files = filesOf(folder, ".tactooth");
        ASSERT_TRUE(!files.empty() || progress.turns == 0);
        for (const fs::path& file : files) {
            const auto opened = openTooth(file);
            ASSERT_TRUE(opened) << opened.error().message();
            const std::uint64_t hash = opened->piece->hash();
            EXPECT_TRUE(hash == teeth[0]->hash() || hash == teeth[1]->hash());
        }
    });
}

TEST_F(KilledSession, WhileItIsExportedLeavesAWholeSurface) {
    const test::TemporaryFolder folder;
    std::vector<std::string> whole;
    for (const auto& tooth : twoTeeth()) {
        ASSERT_TRUE(writeStl(tooth->exported().mesh, folder / "whole.stl"));
        whole.push_back(test::readText(folder / "whole.stl"));
    }
    ASSERT_NE(whole[0], whole[1]);
    killEach("exporting", findKind("exporting")->seconds, nothing, [&](const fs::path& at, Progress& progress) {
        expectNoHalfFile(at, {".stl"});
        const auto files = filesOf(at, ".stl");
        ASSERT_TRUE(!files.empty() || progress.turns == 0);
        for (const fs::path& file : files) {
            const std::string bytes = test::readText(file);
            EXPECT_TRUE(bytes == whole[0] || bytes == whole[1]) << bytes.size() << " bytes";
        }
    });
}

TEST_F(KilledSession, WhileItIsKeptLeavesRecordingsAndTeethThatOpen) {
    killEach("autosave", findKind("autosave")->seconds, nothing, [&](const fs::path& folder, Progress& progress) {
        expectNoHalfFile(folder, {".ttsession", ".tactooth"});
        const auto recordings = filesOf(folder, ".ttsession"), teeth = filesOf(folder, ".tactooth");
        EXPECT_GE(recordings.size(), progress.turns);
        EXPECT_GE(teeth.size(), progress.turns);
        for (const fs::path& file : recordings) (void)replayed(file);
        for (const fs::path& file : teeth) EXPECT_TRUE(openTooth(file));
        const RecordingFolder kept(folder);
        for (const Leftover& leftover : kept.leftovers()) (void)examine(leftover, kept);  // as the next start does
    });
}

TEST_F(KilledSession, WhileItIsRestoredIsNotLost) {
    const test::TemporaryFolder before;
    {
        const SharedProgress progress(before.path());
        killAtTick(3000, before.path(), *progress);  // what there is to restore
    }
    const Replayed all = replayed(before / "s.ttsession");
    ASSERT_GT(all.ticks, 1000U);
    const auto leave = [&](const fs::path& folder) {
        fs::copy_file(before / "s.ttsession", folder / "live-1-0.ttsession");
    };
    double whole = std::numeric_limits<double>::infinity();  // s, without a stall of the machine
    for (int i = 0; i < 3; ++i) {
        const test::TemporaryFolder folder;
        const SharedProgress progress(folder.path());
        leave(folder.path());
        const Clock::time_point began = Clock::now();
        const pid_t child = begin("restore", folder.path());
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        whole = std::min(whole, Seconds(Clock::now() - began).count());
        ASSERT_EQ((*progress).turns, 4U) << "it could not be restored";
    }
    killEach("restore", whole, leave, [&](const fs::path& folder, Progress&) {
        expectNoHalfFile(folder, {".ttsession"});
        int found = 0;
        for (const fs::path& file : filesOf(folder, ".ttsession")) {
            const Replayed one = replayed(file);
            found += one.ticks == all.ticks && one.hash == all.hash ? 1 : 0;
        }
        EXPECT_EQ(found, 1) << "the session that was being restored";
    });
}

}  // namespace
}  // namespace tactooth

int main(int argc, char** argv) {
    if (argc == 4 && std::string_view(argv[1]) == tactooth::kLive) {
        const tactooth::Kind* const kind = tactooth::findKind(argv[2]);
        if (kind == nullptr) return 2;
        const tactooth::SharedProgress progress(argv[3]);
        kind->live(argv[3], *progress);
        return 0;
    }
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
