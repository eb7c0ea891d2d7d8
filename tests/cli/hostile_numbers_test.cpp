// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Absurd numbers for all options of the real program: some in the ordinary tests, 500 with TACTOOTH_HOSTILE=500.
#include "cli/cli_test.h"
#include "cli/hostile_folder.h"
#include "support/mutation.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

using namespace test;

/// Texts that people, scripts and attackers write instead of a number.
const std::vector<std::string> kAbsurd = {"nan",
                                          "NaN",
                                          "-nan",
                                          "nan(0x7)",
                                          "inf",
                                          "-inf",
                                          "+inf",
                                          "Infinity",
                                          "1e999",
                                          "-1e999",
                                          "1e308",
                                          "-1e308",
                                          "1.7976931348623157e308",
                                          "5e-324",
                                          "1e-400",
                                          "-1e-400",
                                          "0",
                                          "-0",
                                          "-1",
                                          "-0.5",
                                          "+",
                                          "-",
                                          "",
                                          " ",
                                          "5 ",
                                          " 5",
                                          "1,5",
                                          "1.5.1",
                                          "1e",
                                          "e5",
                                          "0x10",
                                          "0x1p3",
                                          "0b101",
                                          "010",
                                          "1_000",
                                          "1'000",
                                          "1e3",
                                          "2.5",
                                          "99999999999999999999",
                                          "-99999999999999999999",
                                          "18446744073709551616",
                                          "18446744073709551615",
                                          "9223372036854775808",
                                          "9223372036854775807",
                                          "4294967296",
                                          "4294967295",
                                          "2147483648",
                                          "-2147483649",
                                          "1000000001",
                                          "100%",
                                          "1/2",
                                          "half",
                                          "true",
                                          "null",
                                          "None",
                                          "\xD9\xA1\xD9\xA2",
                                          "\xC2\xBD",
                                          "\xEF\xBC\x95",
                                          "\xE2\x88\x9E",
                                          "%s%n%x",
                                          "\x1b[31m5",
                                          "5\n6",
                                          "5\t",
                                          "\xff\xfe",
                                          "\xC2\x9B"
                                          "5",
                                          "\xE2\x80\xAE"
                                          "5",
                                          "$(id)",
                                          "`id`",
                                          "../5",
                                          "--help5",
                                          "-5e",
                                          "1x1",
                                          "0x0",
                                          "99999x99999",
                                          "16384x16384",
                                          "1e3x1e3",
                                          "nanxnan",
                                          "-16x-16",
                                          "16x",
                                          "x",
                                          "nan,nan",
                                          "inf,0",
                                          "1e300,1e300",
                                          "1,2,nan",
                                          "1e300,0,0",
                                          "1,2,3,4",
                                          "nan%",
                                          "1e300%",
                                          "-5%",
                                          "0%",
                                          "inf%",
                                          "1e15",
                                          "1e14"};

const std::vector<Attack> kOptions = {
    {"feel", "--stiffness=@"},
    {"feel", "--damping=@"},
    {"feel", "--friction=@"},
    {"feel", "--freedom=@"},
    {"cut", "--speed-rpm=@", "--voxel=0.2"},
    {"cut", "--speed-rpm=9000", "--voxel=@"},
    {"demo", "--seconds=@", "--tooth", "in/none.stl", "--out", "out"},
    {"realtime", "--rate=@", "--seconds=nan"},
    {"realtime", "--seconds=@", "--rate=inf"},
    {"sound", "--profile", "in/profile.csv", "--out", "out/a.wav", "--blades=@"},
    {"simplify", "in/ball.stl", "--out", "out/a.stl", "--keep=@"},
    {"subdivide", "in/ball.stl", "--out", "out/a.stl", "--triangles=@"},
    {"subdivide", "in/ball.stl", "--out", "out/a.stl", "--times=@"},
    {"bur", "330", "--out", "out/a.stl", "--triangles=@"},
    {"instrument", "turbine", "--out", "out/a.stl", "--triangles=@"},
    {"tooth", "@", "--out", "out/tooth"},
    {"tooth", "46", "--out", "out/tooth", "--triangles=@"},
    {"tooth", "19", "--out", "out/tooth", "--seed=@"},
    {"tooth", "19", "--out", "out/tooth", "--caries", "mesial", "--caries-width=@"},
    {"tooth", "19", "--out", "out/tooth", "--caries", "mesial", "--caries-depth=@"},
    {"mouth", "--missing", "19", "--out", "out/mouth", "--seed=@"},
    {"mouth", "--missing", "19", "--out", "out/mouth", "--triangles=@"},
    {"mouth", "--missing=@,19", "--out", "out/mouth"},
    {"gallery", "--teeth", "19", "--out", "out/gallery", "--seed=@"},
    {"gallery", "--teeth=@", "19", "--out", "out/gallery"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=@"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=32x32", "--view=@"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=32x32", "--at=@"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=32x32", "--span=@"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=32x32", "--clip=buccal=@"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=32x32", "--transparent=enamel=@"},
    {"render", "in/none.stl", "--out", "out/a.png", "--size=32x32", "--turntable=@"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=32x32", "--mirror=@"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=32x32", "--mirror=22", "--fog=@"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=32x32", "--mirror=22", "--drops=@"},
    {"render", "in/box.stl", "--out", "out/a.png", "--size=32x32", "--target", "in/box.stl", "--range=@"},
    {"case", "new", "out/case", "--from", "in/box.stl", "--units=@"},
    {"case", "new", "out/case", "--from", "in/box.stl", "--turn=@"},
    {"case", "new", "out/case", "--from", "in/box.stl", "--quadrant=@"},
    {"bench", "contact", "--tooth", "in/none.stl", "--resolution=@"},
    {"bench", "contact", "--tooth", "in/none.stl", "--repeat=@"},
    {"bench", "contact", "--tooth", "in/none.stl", "--freedom=@"},
    {"bench", "cut", "--tooth", "in/none.stl", "--voxel=@"},
    {"bench", "cut", "--tooth", "in/none.stl", "--diameter=@"},
    {"bench", "cut", "--tooth", "in/none.stl", "--cores=@"},
    {"bench", "slot", "--tooth", "in/none.stl", "--voxel=@"},
    {"bench", "view", "--tooth", "in/none.stl", "--size=@"},
    {"bench", "view", "--tooth", "in/none.stl", "--frames=@"},
    {"bench", "stability", "--device", "none", "--rate=@"},
    {"--mouth=@", "--device", "none"},
    {"--force-spring=@", "--device", "none"},
};

/// Adds the files that the option refers to.
Attack completed(Attack attack) {
    const Attack feel = {"--tooth", "in/box.stl", "--tool", "in/ball.stl", "--trajectory", "in/poses.csv", "--out"};
    if (attack.front() != "feel" && attack.front() != "cut") return attack;
    const std::string out = attack.front() == "cut" ? "out/a.stl" : "out/a.csv";
    attack.insert(attack.end(), feel.begin(), feel.end());
    attack.push_back(out);
    return attack;
}

TEST(HostileNumbers, EndInOneSentenceOrAResult) {
    HostileFolder folder;
    std::mt19937 random(20261125);
    for (std::size_t i = 0; i < hostileRuns(cases<std::size_t>(100, 30)); ++i) {
        const Attack attack = completed(kOptions[i % kOptions.size()]);
        std::string number = kAbsurd[below(random, kAbsurd.size())];
        if (random() % 4 == 0) mutate(number.empty() ? number = "1" : number, kAbsurd, random);
        if (const auto end = number.find('\0'); end != std::string::npos) number.resize(end);  // no argument has one
        const std::string fault = folder.tried(attack, number);
        EXPECT_EQ(fault, "") << shownAttack(attack, number);
    }
    for (const auto& [code, count] : folder.ends()) RecordProperty("exit" + std::to_string(code), count);
    EXPECT_GT(folder.ends().count(2), 0U);
}

}  // namespace
}  // namespace tactooth
