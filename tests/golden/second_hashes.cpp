// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "second_hashes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <optional>

#include "session/kernel/servo_stage.h"
#include "session/recording/session_replay.h"

namespace tactooth::test {
namespace {

std::string hexOf(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace

std::vector<SecondHash> replayedHashes(const std::filesystem::path& file) {
    std::vector<SecondHash> hashes;
    const auto recording = SessionRecording::open(file);
    EXPECT_TRUE(recording) << recording.error().message();
    if (!recording) return hashes;
    EXPECT_TRUE(recording->journal().isComplete());
    auto replay = SessionReplay::start(*recording);
    EXPECT_TRUE(replay) << replay.error().message();
    if (!replay) return hashes;
    Fnv1a ticks;
    const auto note = [&] {
        hashes.push_back({static_cast<int>(hashes.size()) + 1, hexOf(replay->model().hash()), hexOf(ticks.value())});
        ticks = {};
    };
    std::uint64_t inSecond = 0;
    const auto played = replay->playUntil({}, [&](double time, const Tick& tick) {
        if (time > static_cast<double>(hashes.size() + 1)) note(), inSecond = 0;
        ++inSecond;
        addToHash(ticks, tick);
    });
    EXPECT_TRUE(played) << played.error().message();
    if (!replay->differsAt() && inSecond > 0) note();
    return hashes;
}

std::vector<SecondHash> readHashes(const std::filesystem::path& file) {
    std::ifstream in(file);
    EXPECT_TRUE(in) << file;
    std::vector<SecondHash> hashes;
    for (SecondHash one; in >> one.second >> one.volume >> one.ticks;) hashes.push_back(one);
    return hashes;
}

void writeHashes(const std::filesystem::path& file, const std::vector<SecondHash>& hashes) {
    std::ofstream out(file);
    for (const SecondHash& one : hashes) out << one.second << ' ' << one.volume << ' ' << one.ticks << '\n';
    out.close();
    EXPECT_TRUE(out) << file;
}

std::string differenceOf(const std::vector<SecondHash>& recorded, const std::vector<SecondHash>& replayed,
                         const std::string& name) {
    const auto [was, is] = std::ranges::mismatch(recorded, replayed);
    if (was == recorded.end() && is == replayed.end()) return {};
    const bool hasForces = was != recorded.end() && is != replayed.end() && was->volume == is->volume;
    return fmt::format(
        "Second {} of {} differs in its {}; if that is meant, make the recordings anew with "
        "TACTOOTH_UPDATE_RECORDINGS=1 "
        "golden_tests and say in the commit why.",
        was - recorded.begin() + 1, name, hasForces ? "forces" : "tooth");
}

}  // namespace tactooth::test
