// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Ends the writing commands at a random moment by a random signal. TACTOOTH_KILLS=1000 kills that many times; a few are
// usual.
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "cli/motion_files.h"
#include "geometry/files/temporary_file.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;
namespace fs = std::filesystem;

constexpr int kUsualKills = 60;
constexpr const char* kOld = "old";  // content of a file to be replaced

int numberOfKills() {
    const char* wanted = std::getenv("TACTOOTH_KILLS");
    return wanted == nullptr ? kUsualKills : std::atoi(wanted);
}

/// A command and the files that it leaves in its folder.
struct Job {
    std::string name;
    std::vector<std::string> arguments;  ///< "@/x" stands for x in the folder
    std::vector<std::string> outputs;
    bool replaces = false;                          ///< older files with these names exist
    double seconds = 0;                             ///< duration without a kill
    std::map<std::string, std::string> whole = {};  ///< its output without a kill
};

std::vector<std::string> argumentsIn(const Job& job, const fs::path& folder) {
    std::vector<std::string> arguments;
    for (const std::string& argument : job.arguments) {
        arguments.push_back(argument.starts_with("@") ? folder.string() + argument.substr(1) : argument);
    }
    return arguments;
}

/// All files below a folder by their names in it, and "name/" for folders.
std::map<std::string, std::string> contentOf(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        files[entry.is_directory() ? name + "/" : name] = entry.is_directory() ? "" : readText(entry.path());
    }
    return files;
}

/// Times and similar values differ from run to run, but the size of the output does not.
bool isWhole(const std::string& name, const std::string& content, const std::string& whole) {
    const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
    if (name.ends_with(".csv")) return content.ends_with('\n') && lines(content) == lines(whole);
    if (name.ends_with(".json")) return nlohmann::json::accept(content);
    if (name.ends_with(".toml")) return lines(content) == lines(whole);
    if (name.ends_with(".ttcase")) return content.size() > whole.size() - 100 && content.starts_with("PK");
    return content.size() == whole.size();
}

class Kill : public MotionFiles {
protected:
    void SetUp() override {
        const std::string tooth = plate(), tool = ball(), poses = slot();
        EXPECT_TRUE(writeStl(sphere(Vec3(0, 0, 0), 6, 64, 32), file("scan.stl")));
        const std::string profile =
            text("profile.csv", "t,speed_rpm,power,material\n0,300000,1,enamel\n1,300000,1,enamel\n");
        const Job cut = {"cut",
                         {"cut",
                          "--tooth",
                          tooth,
                          "--tool",
                          tool,
                          "--trajectory",
                          poses,
                          "--speed-rpm",
                          "300000",
                          "--voxel",
                          "0.1",
                          "--out",
                          "@/cut.stl",
                          "--forces",
                          "@/forces.csv",
                          "--removed",
                          "@/removed.csv",
                          "--events",
                          "@/events.csv",
                          "--save",
                          "@/cut.tactooth",
                          "--export-layers",
                          "@/layers"},
                         {"cut.stl", "forces.csv", "removed.csv", "events.csv", "cut.tactooth", "layers/enamel.stl"}};
        jobs_ = {
            cut,
            cut,
            cut,
            {"feel", {"feel", "--tooth", tooth, "--tool", tool, "--trajectory", poses, "--out", "@/f.csv"}, {"f.csv"}},
            {"contact", {"contact", "--tooth", tooth, "--tool", tool, "--poses", poses, "--out", "@/c.csv"}, {"c.csv"}},
            {"simplify", {"simplify", file("scan.stl"), "--keep", "50%", "--out", "@/s.stl"}, {"s.stl"}},
            {"subdivide", {"subdivide", file("scan.stl"), "--times", "2", "--out", "@/s.stl"}, {"s.stl"}},
            {"bur", {"bur", "57", "--out", "@/b.stl"}, {"b.stl"}},
            {"tooth",
             {"tooth", "11", "--triangles", "1000", "--no-cache", "--out", "@/t"},
             {"t/outer.stl", "t/enamel.stl", "t/dentin.stl", "t/pulp.stl"}},
            {"sound",
             {"sound", "--profile", profile, "--out", "@/s.wav", "--spectrogram", "@/s.png"},
             {"s.wav", "s.png"}},
            {"case folder", {"case", "new", "@/case", "--from", file("scan.stl"), "--no-model"}, {"case/case.toml"}},
            {"case file", {"case", "new", "@/case.ttcase", "--from", file("scan.stl"), "--no-model"}, {"case.ttcase"}}};
        jobs_[1].replaces = jobs_[2].replaces = true;
        for (Job& job : jobs_) measure(job);
    }

    /// Down into the plate and along it.
    std::string slot() {
        std::vector<Row> rows;
        for (int i = 0; i < 300; ++i) rows.push_back({i / 1000.0, 0.01 * i, 0, std::max(-1.0, 0.5 - 0.02 * i)});
        return trajectory(rows);
    }

    static void prepare(const Job& job, const fs::path& folder) {
        if (!job.replaces) return;
        for (const std::string& output : job.outputs) {
            fs::create_directories((folder / output).parent_path());
            std::ofstream(folder / output) << kOld;
        }
    }

    static void measure(Job& job) {
        const TemporaryFolder folder;
        prepare(job, folder.path());
        const auto start = std::chrono::steady_clock::now();
        const ProgramRun run = runTactooth(argumentsIn(job, folder.path()));
        job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        ASSERT_EQ(run.exitCode, 0) << job.name << ": " << run.err;
        job.whole = contentOf(folder.path());
        for (const std::string& output : job.outputs) ASSERT_TRUE(job.whole.contains(output)) << job.name << output;
    }

    /// Either all files are there and complete, or none is new. After a SIGKILL, remains of a writer may be left.
    static void expectAllOrNone(const Job& job, const fs::path& folder, bool mayLeave) {
        std::map<std::string, std::string> files = contentOf(folder);
        std::size_t complete = 0, expected = 0;
        for (const auto& [name, whole] : job.whole) {
            if (name.ends_with('/')) continue;
            ++expected;
            const auto found = files.find(name);
            if (found == files.end() || (job.replaces && found->second == kOld)) continue;
            EXPECT_TRUE(isWhole(name, found->second, whole))
                << name << ": " << found->second.size() << " of " << whole.size() << " bytes";
            ++complete;
        }
        EXPECT_TRUE(complete == 0 || complete == expected) << complete << " of " << expected << " files";
        for (const auto& [name, content] : files) {
            if (job.whole.contains(name) && (complete > 0 || job.replaces || mayLeave)) continue;
            const std::string first = name.substr(0, name.find('/'));
            const std::string last = fs::path(name).filename().string();
            EXPECT_TRUE(mayLeave && (isRandomName(first) || isRandomName(last) ||
                                     isRandomName(fs::path(name).parent_path().filename().string())))
                << name << " is left";
        }
    }

    static void expectNothingInTheWay(const Job& job, const fs::path& folder) {
        const ProgramRun again = runTactooth(argumentsIn(job, folder));
        EXPECT_EQ(again.exitCode, 0) << again.err;
        expectAllOrNone(job, folder, false);
    }

    std::vector<Job> jobs_;
};

TEST_F(Kill, AtAnyMomentLeavesAllFilesOrNoneAndNothingInTheWay) {
    constexpr std::array kSignals = {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGPIPE, SIGXFSZ};
    std::mt19937 random(36);
    int ended = 0;
    for (int i = 0; i < numberOfKills() && !HasFailure(); ++i) {
        const Job& job = jobs_[random() % jobs_.size()];
        const int number = kSignals[random() % kSignals.size()];
        const double delay = std::uniform_real_distribution(0.0, 1.1 * job.seconds)(random);
        SCOPED_TRACE(job.name + " ended by " + sigabbrev_np(number) + " after " + std::to_string(delay) + " s, kill " +
                     std::to_string(i));
        const TemporaryFolder folder;
        prepare(job, folder.path());
        RunningTactooth program(argumentsIn(job, folder.path()));
        std::this_thread::sleep_for(std::chrono::duration<double>(delay));
        ::kill(program.number(), number);
        const ProgramRun run = program.wait();
        ended += run.signal != 0 ? 1 : 0;
        EXPECT_TRUE(run.exitCode == 0 || run.signal == number) << run.exitCode << run.err;
        EXPECT_LE(std::count(run.err.begin(), run.err.end(), '\n'), 2) << run.err;  // one of them reports progress
        expectAllOrNone(job, folder.path(), number == SIGKILL);
        const auto left = contentOf(folder.path());
        if (run.exitCode == 0) {
            EXPECT_EQ(left.size(), job.whole.size());
        }
        const bool isLeft = run.signal == SIGKILL && !left.empty();
        if (isLeft || (run.signal == SIGKILL && i % 10 == 0 && job.name != "case folder")) {
            const bool isMade = fs::exists(folder / "case/case.toml");  // a case is not made where one exists
            if (!isMade) expectNothingInTheWay(job, folder.path());
        }
    }
    EXPECT_GT(ended, numberOfKills() / 10) << "the signals came too late";
}

}  // namespace
}  // namespace tactooth
