// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Sealed recordings from outside: the key of the station, and what `session verify` says.
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/motion_files.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;
namespace fs = std::filesystem;
using nlohmann::json;

class Sealed : public test::MotionFiles {
protected:
    ProgramRun run(const std::vector<std::string>& arguments, const std::string& station = "station") {
        return runTactooth(arguments, {{"XDG_DATA_HOME", file(station)}});
    }
    json runJson(std::vector<std::string> arguments, int exitCode, const std::string& station = "station") {
        arguments.emplace_back("--json");
        const ProgramRun done = run(arguments, station);
        EXPECT_EQ(done.exitCode, exitCode) << done.err << done.out;
        return json::parse(done.out, nullptr, false);
    }
    std::string publicKey(const std::string& station = "station") {
        return runJson({"session", "key"}, 0, station)["public_key"];
    }
    /// A stroke over the plate.
    std::string recorded(const std::vector<std::string>& more = {"--seal"}) {
        std::vector<Row> rows;
        for (int i = 0; i < 1500; ++i) rows.push_back({0.001 * i, 0.001 * i, 0.3, 0.05 - 0.0001 * i});
        std::vector<std::string> arguments = {
            "feel",  "--tooth",     plate(),    "--tool",           ball(), "--trajectory", trajectory(rows),
            "--out", file("f.csv"), "--record", file("s.ttsession")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramRun done = run(arguments);
        EXPECT_EQ(done.exitCode, 0) << done.err;
        return file("s.ttsession");
    }
};

TEST_F(Sealed, TheKeyIsMadeOnceAndItsSecretIsNeverShown) {
    const json first = runJson({"session", "key"}, 0), second = runJson({"session", "key"}, 0);
    EXPECT_EQ(first["public_key"], second["public_key"]);
    EXPECT_TRUE(first["new"].get<bool>());
    EXPECT_FALSE(second["new"].get<bool>());
    EXPECT_EQ(first["public_key"].get<std::string>().size(), 64U);
    const fs::path stored = file("station/tactooth/station.key");
    struct stat status {};
    ASSERT_EQ(::stat(stored.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0600U);
    const std::string text = readText(stored);
    const std::string secret = text.substr(text.find("secret ") + 7, 64);
    const ProgramRun plain = run({"session", "key"});
    EXPECT_THAT(plain.out, HasSubstr(first["public_key"].get<std::string>()));
    EXPECT_EQ(plain.out.find(secret), std::string::npos);
    EXPECT_EQ(first.dump().find(secret), std::string::npos);
    EXPECT_NE(publicKey("another"), first["public_key"]);
}

TEST_F(Sealed, ADamagedKeyIsOneSentenceAndNothingIsRecorded) {
    (void)publicKey();
    writeText(file("station/tactooth/station.key"), "Tactooth station key 1\n");
    const ProgramRun shown = run({"session", "key"});
    EXPECT_EQ(shown.exitCode, 2);
    EXPECT_THAT(shown.err, HasSubstr("the key of this station is damaged"));
    const ProgramRun cut = run({"realtime", "--seconds", "1", "--record", file("s.ttsession"), "--seal"});
    EXPECT_EQ(cut.exitCode, 2);
    EXPECT_THAT(cut.err, HasSubstr("the key of this station is damaged"));
    EXPECT_FALSE(fs::exists(file("s.ttsession")));
}

TEST_F(Sealed, ARecordingIsProvenByItsKey) {
    const std::string session = recorded();
    const std::string key = publicKey();
    const json found = runJson({"session", "verify", session}, 0);
    EXPECT_EQ(found["seal"]["verdict"], "intact");
    EXPECT_EQ(found["seal"]["public_key"], key);
    EXPECT_TRUE(found["seal"]["this_station"].get<bool>());
    EXPECT_TRUE(found["same"].get<bool>());
    EXPECT_NEAR(found["seal"]["signed_s"].get<double>(), 1.5, 0.1);
    EXPECT_FALSE(runJson({"session", "verify", session}, 0, "another")["seal"]["this_station"].get<bool>());
    EXPECT_EQ(run({"session", "verify", session, "--key", key}).exitCode, 0);
    const ProgramRun plain = run({"session", "verify", session});
    EXPECT_THAT(plain.out, HasSubstr("no byte was changed"));
    EXPECT_THAT(plain.out, HasSubstr("(this station)"));
    const json info = runJson({"session", "info", session}, 0);
    EXPECT_TRUE(info["sealed"].get<bool>());
    EXPECT_EQ(info["public_key"], key);
    EXPECT_THAT(run({"session", "info", session}).out, HasSubstr("sealed by: " + key));
}

TEST_F(Sealed, AnotherKeyIsNoProof) {
    const std::string session = recorded(), other = publicKey("another");
    const json found = runJson({"session", "verify", session, "--key", other}, 1);
    EXPECT_EQ(found["seal"]["verdict"], "other_key");
    EXPECT_THAT(run({"session", "verify", session, "--key", other}).out, HasSubstr("Sealed by another key"));
    const ProgramRun wrong = run({"session", "verify", session, "--key", "1234"});
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_THAT(wrong.err, HasSubstr("64 hexadecimal digits"));
}

TEST_F(Sealed, AnUnsealedRecordingPassesOnlyWithoutAKey) {
    const std::string session = recorded({});
    EXPECT_EQ(runJson({"session", "verify", session}, 0)["seal"]["verdict"], "not_sealed");
    EXPECT_EQ(runJson({"session", "verify", session, "--key", publicKey()}, 1)["seal"]["verdict"], "not_sealed");
    EXPECT_FALSE(runJson({"session", "info", session}, 0)["sealed"].get<bool>());
}

TEST_F(Sealed, AChangedByteIsFoundAndItsSecondNamed) {
    const std::string session = recorded();
    std::string bytes = readText(session);
    const std::size_t place = bytes.size() - 700;  // among the last blocks
    bytes[place] = static_cast<char>(bytes[place] ^ 4);
    writeText(file("changed.ttsession"), bytes);
    const json found = runJson({"session", "verify", file("changed.ttsession")}, 1);
    EXPECT_EQ(found["seal"]["verdict"], "changed");
    EXPECT_LE(found["seal"]["changed_from_byte"].get<std::size_t>(), place);
    EXPECT_GT(found["seal"]["changed_before_byte"].get<std::size_t>(), place);
    EXPECT_GT(found["seal"]["changed_from_s"].get<double>(), 0.3);
    EXPECT_THAT(run({"session", "verify", file("changed.ttsession")}).out, HasSubstr("changed after "));
}

TEST_F(Sealed, ACutOffRecordingIsProvenUpToItsLastSignature) {
    const std::string session = recorded();
    const std::string bytes = readText(session);
    writeText(file("cut.ttsession"), bytes.substr(0, bytes.size() - 30));
    const json found = runJson({"session", "verify", file("cut.ttsession")}, 1);
    EXPECT_EQ(found["seal"]["verdict"], "cut_off");
    EXPECT_TRUE(found["same"].get<bool>());
    EXPECT_THAT(run({"session", "verify", file("cut.ttsession")}).out, HasSubstr("The end is missing"));
}

TEST_F(Sealed, RepairedAndTrimmedCopiesAreNotSealedAndSaySo) {
    const std::string session = recorded();
    const ProgramRun repaired = run({"session", "repair", session, "--out", file("r.ttsession")});
    const ProgramRun trimmed = run({"session", "trim", session, "--to", "1", "--out", file("t.ttsession")});
    for (const ProgramRun& done : {repaired, trimmed}) {
        EXPECT_EQ(done.exitCode, 0) << done.err;
        EXPECT_THAT(done.out, HasSubstr("The copy is not sealed"));
    }
    for (const char* name : {"r.ttsession", "t.ttsession"}) {
        EXPECT_EQ(runJson({"session", "verify", file(name)}, 0)["seal"]["verdict"], "not_sealed") << name;
    }
}

TEST_F(Sealed, SealNeedsARecording) {
    EXPECT_EQ(run({"realtime", "--seconds", "1", "--seal"}).exitCode, 2);
    EXPECT_EQ(run({"--sealed", "--no-record"}).exitCode, 2);
}

}  // namespace
}  // namespace tactooth
