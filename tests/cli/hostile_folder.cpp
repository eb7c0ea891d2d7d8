// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/hostile_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "geometry/io/stl_writer.h"
#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"
#include "support/shapes.h"
#include "support/text_file.h"

namespace tactooth::test {
namespace {

/// A ball of one millimetre comes down into a box and slides.
std::string poses() {
    std::string text = "t,x,y,z,qw,qx,qy,qz\n";
    for (int i = 0; i < 40; ++i) {
        const double down = 0.2 - 0.02 * std::min(i, 20), along = 0.02 * std::max(0, i - 20);
        text += numberText(0.002 * i) + "," + numberText(along) + ",0," + numberText(down) + ",1,0,0,0\n";
    }
    return text;
}

}  // namespace

std::size_t hostileRuns(std::size_t usual) {
    const char* hundredths = std::getenv("TACTOOTH_HOSTILE");
    if (hundredths == nullptr) return usual;
    return usual * static_cast<std::size_t>(toNumber<int>(hundredths).value_or(100)) / 100;
}

HostileFolder::HostileFolder() {
    std::filesystem::create_directory(folder_ / "in");
    std::filesystem::create_directory(folder_ / "out");
    EXPECT_TRUE(writeStl(box(Vec3(-4, -4, -6), Vec3(4, 4, 0)), input("box.stl")));
    EXPECT_TRUE(writeStl(sphere(Vec3(0, 0, 0.5), 0.5, 12, 8), input("ball.stl")));
    writeText(input("poses.csv"), poses());
    writeText(input("profile.csv"),
              "t,speed_rpm,power,material\n0,300000,0,none\n0.02,300000,5,enamel\n0.05,300000,0,none\n");
}

std::string HostileFolder::tried(const Attack& attack, const std::string& instead) {
    Attack words;
    for (std::string word : attack) {
        if (const auto at = word.find('@'); at != std::string::npos) word.replace(at, 1, instead);
        words.push_back(std::move(word));
    }
    const WatchedRun run = watchTactooth(words, folder_.path());
    ++ends_[run.exitCode];
    const std::filesystem::path out = folder_ / "out";
    std::string fault = faultOf(run);
    if (fault.empty()) fault = faultOfFiles(out);
    if (fault.empty() && run.exitCode == 2 && !std::filesystem::is_empty(out)) fault = "it failed and left a file";
    std::filesystem::remove_all(out);
    std::filesystem::create_directory(out);
    return fault;
}

std::string shownAttack(const Attack& attack, const std::string& instead) {
    std::string line;
    for (const std::string& word : attack) line += (line.empty() ? "" : " ") + word;
    return line + "   @ = " + displayShort(instead, 100);
}

}  // namespace tactooth::test
