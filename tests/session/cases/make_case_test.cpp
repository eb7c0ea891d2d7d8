// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/make_case.h"

#include <gtest/gtest.h>

#include <fstream>

#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"
#include "instruments/builtin_tooth.h"
#include "session/cases/open_case.h"
#include "session/cases/write_case.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

/// Some built-in lower left teeth, each with its layers, in a made-up arch.
class MouthOfFiles : public ::testing::Test {
protected:
    void SetUp() override {
        int place = 0;
        for (const int fdi : {33, 34, 35, 36}) {
            const BuiltinTooth tooth = makeTooth({.fdi = fdi, .triangles = 1500, .seed = 0, .lesion = {}});
            const double angle = 0.35 * place++;
            const Pose pose{30 * Vec3(std::cos(angle), std::sin(angle), 0),
                            Quat(Eigen::AngleAxisd(angle - 1.5708, Vec3::UnitZ()))};  // +y looks outward
            poses_.push_back(pose);
            const std::string name = std::string("T").append(std::to_string(fdi));
            for (const auto& [word, mesh] : {std::pair("outer", &tooth.outer), std::pair("enamel", &tooth.enamel),
                                             std::pair("dentin", &tooth.dentin), std::pair("pulp", &tooth.pulp)}) {
                ASSERT_TRUE(writeStl(transformed(*mesh, pose), folder_ / (name + "_" + word + ".stl")));
            }
        }
        ASSERT_TRUE(writeStl(test::box(Vec3(-5, -5, -40), Vec3(35, 35, -30)), folder_ / "jaw_bone.stl"));
    }

    test::TemporaryFolder folder_;
    std::vector<Pose> poses_;
};

TEST_F(MouthOfFiles, BecomesACaseWhereAllStandsInPlace) {
    const auto made = makeCase({.from = {folder_.path()}, .title = "Mouth", .licence = "CC0-1.0"});
    ASSERT_TRUE(made) << made.error().message();
    ASSERT_EQ(made->description.teeth.size(), 4u);
    ASSERT_EQ(made->description.around.size(), 1u);
    const auto bytes = packCase(made->files).value();
    const auto store = CaseStore::openArchive(bytes, "m.ttcase");
    ASSERT_TRUE(store) << store.error().message();
    const auto bodies = caseBodies(*store, *readCaseDescription(*store));
    ASSERT_TRUE(bodies);
    for (const CaseBody& body : *bodies) {
        const std::string file = body.name == "jaw_bone" ? body.name : body.name + "_outer";
        const TriangleMesh came = readStl(folder_ / (file + ".stl")).value();
        ASSERT_EQ(came.triangles.size(), body.surface.triangles.size());
        for (std::size_t v = 0; v < came.vertices.size(); v += 50) {
            EXPECT_LT((came.vertices[v] - body.surface.vertices[v]).norm(), 1e-4F);
        }
    }
    for (std::size_t i = 0; i < poses_.size(); ++i) {
        const CaseTooth& tooth = made->description.teeth[i];
        EXPECT_EQ(tooth.fdi, 33 + static_cast<int>(i));
        // Crown up and cheek outward, within the lean of a long axis that follows the tooth's shape.
        EXPECT_GT((tooth.toothInCase.rotation * Vec3::UnitZ()).z(), 0.93) << tooth.name;
        EXPECT_GT((tooth.toothInCase.rotation * Vec3::UnitY()).dot(poses_[i].rotation * Vec3::UnitY()), 0.85)
            << tooth.name;
    }
    const auto opened = openCase(*store, "36");
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_EQ(opened->teeth->layers().size(), 13u);
}

TEST_F(MouthOfFiles, IsWrittenAsAFolderThatOpens) {
    const auto made = makeCase({.from = {folder_ / "T36_outer.stl", folder_ / "T36_pulp.stl"}});
    ASSERT_TRUE(made) << made.error().message();
    const fs::path out = folder_ / "case";
    ASSERT_TRUE(writeCase(made->files, out));
    EXPECT_TRUE(openCase(out));
    const auto again = writeCase(made->files, out);
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().message().find("there is something already"), std::string::npos);
}

TEST_F(MouthOfFiles, ASurfaceGivenTwiceIsRefused) {
    fs::create_directories(folder_ / "again");
    fs::copy_file(folder_ / "T36_outer.stl", folder_ / "again/T36.stl");
    const auto made = makeCase({.from = {folder_.path()}});
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message().find("has this surface already"), std::string::npos) << made.error().message();
}

TEST(MakeCase, ASingleSurfaceGetsAModelAndSaysSo) {
    const test::TemporaryFolder folder;
    const BuiltinTooth molar = makeTooth({.fdi = 36, .triangles = 3000, .seed = 0, .lesion = {}});
    TriangleMesh inCentimetres = molar.outer;
    for (Vec3f& vertex : inCentimetres.vertices) vertex *= 0.1F;
    ASSERT_TRUE(writeStl(inCentimetres, folder / "L6.stl"));
    const auto made = makeCase({.from = {folder / "L6.stl"}, .quadrant = 3});
    ASSERT_TRUE(made) << made.error().message();
    const CaseTooth& tooth = made->description.teeth.front();
    EXPECT_EQ(tooth.fdi, 36);
    EXPECT_TRUE(tooth.isModelled);
    ASSERT_EQ(tooth.layers.size(), 3u);
    EXPECT_EQ(tooth.layers.front().second, tooth.outer);  // enamel is what the dentin leaves
    EXPECT_NE(tooth.assumed.front().find("Units taken as cm"), std::string::npos);
    const auto bytes = packCase(made->files).value();
    EXPECT_TRUE(openCase(CaseStore::openArchive(bytes, "x").value()));
}

TEST(MakeCase, WhatWasAssumedIsSaidInEveryLanguage) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeStl(test::box(Vec3(-4, -4, -12), Vec3(4, 4, 8)), folder / "L6_outer.stl"));
    ASSERT_TRUE(writeStl(test::box(Vec3(-3, -3, -11), Vec3(3, 3, 5)), folder / "L6_dentin.stl"));
    ASSERT_TRUE(writeStl(test::box(Vec3(-9, -9, -30), Vec3(9, 9, -13)), folder / "bone.stl"));
    const auto made = makeCase({.from = {folder.path()}, .quadrant = 3});
    ASSERT_TRUE(made) << made.error().message();
    const CaseDescription& described = made->description;
    ASSERT_EQ(made->ofTeeth.size(), described.teeth.size());
    ASSERT_EQ(made->ofAround.size(), described.around.size());
    ASSERT_EQ(described.around.size(), 1u);
    const auto expectBoth = [](const std::vector<Message>& messages, const std::vector<std::string>& english) {
        ASSERT_FALSE(messages.empty());
        ASSERT_EQ(messages.size(), english.size());
        for (std::size_t i = 0; i < messages.size(); ++i) {
            EXPECT_EQ(messages[i].in(Language::English), english[i]);  // what the file says
            EXPECT_NE(messages[i].in(Language::Japanese), english[i]);
        }
    };
    expectBoth(made->ofTeeth.front(), described.teeth.front().assumed);
    expectBoth(made->ofAround.front(), described.around.front().assumed);
    EXPECT_EQ(described.around.front().assumed, std::vector<std::string>{"Closed and sound as it came."});
}

TEST(MakeCase, NamesThatDifferInForeignLettersAloneGetFilesOfTheirOwn) {
    const test::TemporaryFolder folder;
    for (const auto& [name, x] : {std::pair("右", 0.0), std::pair("左", 12.0)}) {
        const Vec3 low(x - 4, -4, -12), high(x + 4, 4, 8);
        ASSERT_TRUE(writeStl(test::box(low, high), folder / (std::string(name) + "_outer.stl")));
        ASSERT_TRUE(
            writeStl(test::box(low.array() + 1, high.array() - 1), folder / (std::string(name) + "_dentin.stl")));
    }
    const auto made = makeCase({.from = {folder.path()}, .quadrant = {}});
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_EQ(made->description.teeth[0].name, "右");
    EXPECT_EQ(made->description.teeth[1].name, "左");
    EXPECT_NE(made->description.teeth[0].outer, made->description.teeth[1].outer);
    EXPECT_EQ(made->files.size(), 5u);
    const auto bytes = packCase(made->files);
    ASSERT_TRUE(bytes) << bytes.error().message();
    EXPECT_TRUE(openCase(CaseStore::openArchive(*bytes, "x").value()));
}

TEST(MakeCase, AnUnusableSurfaceIsNamed) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "bad.stl") << "nothing";
    const auto made = makeCase({.from = {folder / "bad.stl"}});
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message().find("bad.stl"), std::string::npos);
    EXPECT_FALSE(makeCase({.from = {folder / "missing"}}));
}

/// The seven CT teeth of a patient with the jaw around them.
TEST(MakeCase, TheTeethOfACtBecomeOneCase) {
    const auto data = test::realTeethFolder();
    if (!data || !fs::exists(*data / "openmandible")) GTEST_SKIP() << "no CT teeth here";
    const auto made = makeCase(
        {.from = {*data / "openmandible/layered", *data / "openmandible/mandible_cortical_bone.stl"}, .quadrant = 3});
    ASSERT_TRUE(made) << made.error().message();
    ASSERT_EQ(made->description.teeth.size(), 7u);
    for (const CaseTooth& tooth : made->description.teeth) {
        EXPECT_FALSE(tooth.isModelled) << tooth.name;
        EXPECT_EQ(tooth.layers.size(), 3u) << tooth.name;
        EXPECT_GT((tooth.toothInCase.rotation * Vec3::UnitZ()).z(), 0.8) << tooth.name;
    }
    // The lower left molar's cheek is on the patient's left, the incisor's lip in front (x to the left, y to the back).
    EXPECT_GT((made->description.teeth[5].toothInCase.rotation * Vec3::UnitY()).x(), 0.6);
    EXPECT_LT((made->description.teeth[0].toothInCase.rotation * Vec3::UnitY()).y(), -0.6);
    const auto bytes = packCase(made->files).value();
    const auto opened = openCase(CaseStore::openArchive(bytes, "ct.ttcase").value(), "36");
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_EQ(opened->teeth->layers().size(), 22u);
}

}  // namespace
}  // namespace tactooth
