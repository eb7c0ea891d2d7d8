// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Batch runs that are recorded, and what the session commands make of the recordings.
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/motion_files.h"
#include "journal/file/journal_reader.h"
#include "journal/file/journal_repair.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;
namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

class Record : public test::MotionFiles {
protected:
    /// Strokes across the plate, down to `deepest` mm below its face.
    std::string strokes(int rows = 1200, double deepest = 0.4) {
        std::vector<Row> all;
        for (int i = 0; i < rows; ++i) {
            const double share = static_cast<double>(i) / rows;
            all.push_back({0.001 * i, 2 * std::sin(12 * share), 0.3, 0.1 - (0.1 + deepest) * share});
        }
        return trajectory(all);
    }
    std::vector<std::string> cut(const std::string& feed, const std::string& out, double deepest = 0.4) {
        return {"cut",
                "--tooth",
                plate(),
                "--tool",
                ball(),
                "--trajectory",
                strokes(1200, deepest),
                "--speed-rpm",
                "300000",
                "--voxel",
                "0.1",
                "--feed",
                feed,
                "--out",
                file(out + ".stl"),
                "--forces",
                file(out + ".csv")};
    }
    std::vector<std::string> feel(const std::string& tooth, const std::string& out) {
        return {"feel",       "--tooth", tooth,         "--tool", ball(),  "--trajectory",    strokes(600),
                "--friction", "0.3",     "--stiffness", "20",     "--out", file(out + ".csv")};
    }
    static std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    static ProgramRun succeed(const std::vector<std::string>& arguments) {
        ProgramRun run = runTactooth(arguments);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return run;
    }
    static json jsonOf(const std::vector<std::string>& arguments) { return json::parse(succeed(arguments).out); }

    /// The rows of a table of ticks without the column "micros", which no run has twice.
    std::string forces(const std::string& name) {
        std::ifstream table(file(name));
        std::string all;
        for (std::string line; std::getline(table, line);) {
            std::istringstream fields(line);
            int column = 0;
            for (std::string field; std::getline(fields, field, ','); ++column) {
                if (column != 16) all += field + ',';
            }
            all += '\n';
        }
        return all;
    }
    /// The recording leads to the same files as the run.
    void expectSameFromRecording(const std::string& out) {
        const auto summary = jsonOf({"replay", file("s.ttsession"), "--out", file("again"), "--json"});
        EXPECT_TRUE(summary["same"]);
        EXPECT_TRUE(summary["complete"]);
        const auto own = split(forces(out + ".csv")), again = split(forces("again/forces.csv"));
        ASSERT_EQ(own.size(), again.size());
        for (std::size_t i = 0; i < own.size(); ++i) {  // times are summed up anew
            EXPECT_EQ(own[i].substr(own[i].find(',')), again[i].substr(again[i].find(','))) << i;
        }
        if (fs::exists(file(out + ".stl"))) {
            EXPECT_EQ(readText(file(out + ".stl")), readText(file("again/cut.stl")));
        }
    }
    static std::vector<std::string> split(const std::string& text) {
        std::istringstream in(text);
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        return lines;
    }
};

TEST_F(Record, ACutIsReplayedBitForBitAndHasTheNumbersOfOneThatIsNotRecorded) {
    for (const std::string feed : {"law", "rigid"}) {
        SCOPED_TRACE(feed);
        const ProgramRun plain = succeed(cut(feed, "plain"));
        const ProgramRun recorded = succeed(with(cut(feed, "recorded"), {"--record", file("s.ttsession")}));
        EXPECT_EQ(plain.out.substr(0, plain.out.find("triangles")),
                  recorded.out.substr(0, recorded.out.find("triangles")));
        EXPECT_EQ(readText(file("plain.stl")), readText(file("recorded.stl")));
        EXPECT_EQ(forces("plain.csv"), forces("recorded.csv"));
        expectSameFromRecording("recorded");
    }
}

TEST_F(Record, ACutThatGoesOnFromASavedToothIsReplayed) {
    succeed(with(cut("law", "first", 0.2), {"--save", file("first.tactooth")}));
    auto more = cut("law", "second");
    more[2] = file("first.tactooth");
    std::erase(more, "--voxel"), std::erase(more, "0.1");
    succeed(with(more, {"--record", file("s.ttsession")}));
    expectSameFromRecording("second");
}

TEST_F(Record, ATouchIsReplayedAlsoOnAnOpenSurface) {
    ASSERT_TRUE(writeStl(
        [] {
            TriangleMesh square;
            square.vertices = {Vec3f(-9, -9, 0), Vec3f(9, -9, 0), Vec3f(9, 9, 0), Vec3f(-9, 9, 0)};
            square.triangles = {{0, 1, 2}, {0, 2, 3}};
            return square;
        }(),
        file("square.stl")));
    for (const std::string& tooth : {plate(), file("square.stl")}) {
        SCOPED_TRACE(tooth);
        succeed(feel(tooth, "plain"));
        succeed(with(feel(tooth, "recorded"), {"--record", file("s.ttsession")}));
        EXPECT_EQ(forces("plain.csv"), forces("recorded.csv"));
        expectSameFromRecording("recorded");
    }
}

TEST_F(Record, TheDemonstrationLeavesItsRecording) {
    succeed({"demo", "--out", file("demo"), "--seconds", "1", "--record", file("s.ttsession")});
    for (const std::string& session : {file("demo/session.ttsession"), file("s.ttsession")}) {
        const auto summary = jsonOf({"replay", session, "--out", file("again"), "--json"});
        EXPECT_TRUE(summary["same"]);
        EXPECT_EQ(readText(file("demo/cut.stl")), readText(file("again/cut.stl")));
        EXPECT_EQ(forces("demo/forces.csv"), forces("again/forces.csv"));
    }
}

TEST_F(Record, ReplacesARecordingOrAnEmptyFileAndNothingElse) {
    text("s.ttsession", "");
    succeed(with(feel(plate(), "out"), {"--record", file("s.ttsession")}));
    const auto size = fs::file_size(file("s.ttsession"));
    fs::create_symlink(file("s.ttsession"), file("link.ttsession"));
    succeed(with(feel(plate(), "out"), {"--record", file("link.ttsession")}));
    EXPECT_TRUE(fs::is_symlink(file("link.ttsession")));
    EXPECT_NEAR(static_cast<double>(fs::file_size(file("s.ttsession"))), static_cast<double>(size), 100);
    fs::remove(file("out.csv"));
    text("thesis.txt", "The only copy.");
    fs::create_directory(file("folder"));
    for (const std::string& name : {file("thesis.txt"), file("folder"), plate(), std::string("/dev/null")}) {
        SCOPED_TRACE(name);
        for (const auto& command : {feel(plate(), "out"), {"realtime", "--seconds", "1"}}) {
            const ProgramRun run = runTactooth(with(command, {"--record", name}));
            EXPECT_EQ(run.exitCode, 2);
            EXPECT_THAT(run.err, StartsWith("tactooth: "));
            EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        }
    }
    EXPECT_EQ(readText(file("thesis.txt")), "The only copy.");
    EXPECT_FALSE(fs::exists(file("out.csv")));
}

TEST_F(Record, RefusesTheNameOfAnotherFileOfTheRun) {
    const ProgramRun run = runTactooth(with(feel(plate(), "out"), {"--record", file("out.csv")}));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

/// A long run, ended from outside: the recording has an end, and nothing else is left.
TEST_F(Record, ASignalEndsTheRecordingInOrder) {
    for (const int number : {SIGINT, SIGTERM}) {
        const std::string session = file("signal.ttsession");
        fs::remove(session);
        auto arguments = feel(plate(), "signal");
        arguments[6] = strokes(60'000);
        RunningTactooth run(with(arguments, {"--record", session}));
        std::error_code ignored;
        const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(300);
        while (!(fs::exists(session) && fs::file_size(session, ignored) > 30'000)) {
            ASSERT_LT(std::chrono::steady_clock::now(), limit);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ::kill(run.number(), number);
        const ProgramRun ended = run.wait();
        EXPECT_EQ(ended.signal, number) << ended.err;
        EXPECT_FALSE(fs::exists(file("signal.csv")));
        const auto info = jsonOf({"session", "info", session, "--json"});
        EXPECT_TRUE(info["complete"]);
        EXPECT_LT(info["ticks"], 60'000);
        EXPECT_EQ(runTactooth({"replay", session}).exitCode, 0);
    }
}

class SessionTools : public Record {
protected:
    std::string recorded() {
        succeed(with(cut("law", "cut"), {"--record", file("s.ttsession")}));
        return file("s.ttsession");
    }
};

TEST_F(SessionTools, ListWhatHappened) {
    const std::string session = recorded();
    const auto events = jsonOf({"session", "events", session, "--json"});
    EXPECT_TRUE(events["same"]);
    std::vector<std::string> names;
    double last = 0;
    for (const auto& event : events["events"]) {
        names.push_back(event["event"]);
        EXPECT_GE(event["t"], last);
        last = event["t"];
    }
    for (const char* expected : {"bur", "cut begun", "cut ended", "first contact"}) {
        EXPECT_THAT(names, ::testing::Contains(expected));
    }
    const ProgramRun lines = succeed({"session", "events", session});
    EXPECT_EQ(split(lines.out).size(), names.size());
}

/// Copies of one recording whose headers say that they are parts of a session.
TEST_F(SessionTools, NameTheOtherPartsOfASession) {
    const std::string session = recorded();
    EXPECT_TRUE(jsonOf({"session", "info", session, "--json"})["part"].is_null());
    EXPECT_THAT(succeed({"session", "info", session}).out, ::testing::Not(HasSubstr("part")));
    auto header = nlohmann::json::parse(JournalReader::open(session).value().headerJson());
    for (const int number : {1, 2, 4}) {
        header["part"] = {{"session", "0123456789abcdef"}, {"number", number}};
        ASSERT_TRUE(repairJournal(session, file("part" + std::to_string(number) + ".ttsession"), header.dump()));
    }
    const std::string first = file("part1.ttsession"), second = file("part2.ttsession");
    EXPECT_EQ(jsonOf({"session", "info", first, "--json"})["part_behind"], second);
    EXPECT_TRUE(jsonOf({"session", "info", first, "--json"})["part_before"].is_null());
    EXPECT_THAT(succeed({"session", "info", first}).out, HasSubstr("goes on:   the next part is " + second + "\n"));
    const std::string text = succeed({"session", "info", second}).out;
    EXPECT_THAT(text, HasSubstr("part:      2 of its session; the part before is " + first + "\n"));
    EXPECT_THAT(text, ::testing::Not(HasSubstr("goes on")));
    EXPECT_THAT(succeed({"session", "info", file("part4.ttsession")}).out,
                HasSubstr("part:      4 of its session; the part before is not in this folder\n"));
}

TEST_F(SessionTools, ExportTheTableOfTheRun) {
    const std::string session = recorded();
    succeed({"session", "export", "csv", session, "--out", file("ticks.csv")});
    const auto own = split(forces("cut.csv")), table = split(forces("ticks.csv"));
    ASSERT_EQ(own.size(), table.size());
    EXPECT_EQ(own.front(), table.front());
    EXPECT_EQ(own.back().substr(own.back().find(',')), table.back().substr(table.back().find(',')));
}

/// Read by Python's standard library, which checks each record, checksum and schema.
TEST_F(SessionTools, ExportMcapThatASecondReaderReads) {
    const std::string session = recorded();
    succeed({"session", "export", "mcap", session, "--out", file("s.mcap"), "--rate", "50"});
    const std::string line =
        TACTOOTH_PYTHON " '" TACTOOTH_MCAP_READER "' '" + file("s.mcap") + "' > '" + file("s.json") + "'";
    ASSERT_EQ(std::system(line.c_str()), 0);
    const json read = json::parse(readText(file("s.json")));
    for (const char* topic : {"/tool/pose", "/tool/force", "/spindle"}) EXPECT_NEAR(read[topic]["messages"], 60, 2);
    EXPECT_EQ(read["/tool/pose"]["schema"], "foxglove.PoseInFrame");
    EXPECT_EQ(read["/events"]["messages"], jsonOf({"session", "events", session, "--json"})["events"].size());
    const json last = read["/tool/pose"]["last"][1];
    EXPECT_EQ(last["frame_id"], "tooth");
    EXPECT_NEAR(last["pose"]["position"]["y"], 0.3, 0.1);
    EXPECT_GT(read["/spindle"]["last"][1]["speed"], 100'000);
    const double seconds =
        1e-9 * (read["/tool/pose"]["last"][0].get<double>() - read["/tool/pose"]["first"][0].get<double>());
    EXPECT_NEAR(seconds, 1.2, 0.05);
}

TEST_F(SessionTools, TrimTheEndSoThatItIsReplayed) {
    const std::string session = recorded();
    succeed({"session", "trim", session, "--to", "0.5", "--out", file("part.ttsession")});
    const auto part = jsonOf({"session", "info", file("part.ttsession"), "--json"});
    EXPECT_TRUE(part["complete"]);
    EXPECT_GE(part["seconds"], 0.49);
    EXPECT_LT(part["seconds"], 1.0);
    const auto summary = jsonOf({"replay", file("part.ttsession"), "--json"});
    EXPECT_TRUE(summary["same"]);
    // A cut right after the last tick of the part is no longer in it, but in a replay until that tick.
    const std::string before = std::to_string(part["seconds"].get<double>() - 1e-6);
    EXPECT_EQ(summary["hash"], jsonOf({"replay", session, "--until", before, "--json"})["hash"]);
    succeed({"session", "trim", session, "--out", file("all.ttsession")});
    EXPECT_EQ(jsonOf({"replay", file("all.ttsession"), "--json"})["hash"],
              jsonOf({"replay", session, "--json"})["hash"]);
}

TEST_F(SessionTools, RefuseToTrimWhatCouldNotBeReplayed) {
    const std::string session = recorded();
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
        {{"--from", "0.5"}, "keyframe"}, {{"--from", "0.5", "--to", "0.4"}, "--from"}, {{"--from", "900"}, "ends at"}};
    for (const auto& [options, part] : wrong) {
        const ProgramRun run =
            runTactooth(with(with({"session", "trim", session}, options), {"--out", file("part.ttsession")}));
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_THAT(run.err, AllOf(StartsWith("tactooth: "), HasSubstr(part)));
        EXPECT_FALSE(fs::exists(file("part.ttsession")));
    }
}

TEST_F(SessionTools, RefuseWhatIsNoRecordingAndToWriteOverIt) {
    text("text.ttsession", "no recording");
    const std::string session = recorded();
    const std::string before = readText(session);
    const std::vector<std::vector<std::string>> commands = {
        {"session", "events"}, {"session", "export", "csv"}, {"session", "export", "mcap"}, {"session", "trim"}};
    for (const auto& command : commands) {
        auto missing = with(command, {file("text.ttsession")});
        auto same = with(command, {session, "--out", session});
        if (command.back() != "events") missing = with(missing, {"--out", file("out.bin")});
        EXPECT_EQ(runTactooth(missing).exitCode, 2) << command.back();
        EXPECT_FALSE(fs::exists(file("out.bin")));
        EXPECT_EQ(runTactooth(same).exitCode, 2) << command.back();
    }
    EXPECT_EQ(readText(session), before);
}

}  // namespace
}  // namespace tactooth
