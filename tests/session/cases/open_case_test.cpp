// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/open_case.h"

#include <gtest/gtest.h>

#include "geometry/files/atomic_file.h"
#include "geometry/io/stl_reader.h"
#include "geometry/mesh/mesh_report.h"
#include "session/cases/block_case.h"
#include "session/cases/loaded_tooth.h"
#include "session/io/material_file.h"
#include "support/materials.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

/// The case with a piece of its text replaced.
Expected<OpenedCase> openChanged(const std::string& from, const std::string& to, const std::string& tooth = {}) {
    auto files = test::blockCase();
    std::string text(asText(files[0].bytes));
    const std::size_t at = text.find(from);
    if (at != std::string::npos) text.replace(at, from.size(), to);
    files[0].bytes = bytesOf(text);
    const auto bytes = packCase(files).value();
    const auto store = CaseStore::openArchive(bytes, "x.ttcase");
    if (!store) return Unexpected{store.error()};
    return openCase(*store, tooth);
}

TEST(OpenCase, AllStandsInItsPlace) {
    const auto opened = openChanged("", "");
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_EQ(opened->tooth, "36");
    EXPECT_EQ(opened->mesialX, 1);
    EXPECT_NEAR(opened->box.sizes().z(), 10, 1e-9);
    const LayeredTooth& teeth = *opened->teeth;
    EXPECT_EQ(teeth.outer()->mesh().triangles.size(), 36u);
    EXPECT_EQ(teeth.materialAt(Vec3(2.5, 0, 3)), test::kEnamel);
    EXPECT_EQ(teeth.materialAt(Vec3(0, 0, 0)), test::kDentin);
    EXPECT_EQ(teeth.materialAt(Vec3(10, 0, 1)), test::kDentin);
    EXPECT_EQ(teeth.materialAt(Vec3(12.5, 0, 4)), test::kEnamel);
    EXPECT_EQ(teeth.materialAt(Vec3(-5, 0, -12)), test::kOther);
    EXPECT_EQ(teeth.layers().size(), 5u);
}

TEST(OpenCase, TheToothThatIsWorkedOnGivesTheFrame) {
    const auto opened = openChanged("", "", "37");
    ASSERT_TRUE(opened);
    EXPECT_NEAR(opened->box.center().x(), 0, 1e-9);
    EXPECT_EQ(opened->teeth->materialAt(Vec3(-10, 0, -1)), test::kDentin);
    EXPECT_EQ(opened->teeth->materialAt(Vec3(-15, 0, -13)), test::kOther);
}

TEST(OpenCase, ATurnedToothTurnsTheOthers) {
    // A quarter turn about z: +x of the tooth is +y of the case.
    const auto opened = openChanged("position = [10.0, 0.0, 1.0]",
                                    "position = [10.0, 0.0, 1.0]\nrotation = [0.7071068, 0.0, 0.0, 0.7071068]", "37");
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->teeth->materialAt(Vec3(0, 10, -1)), test::kDentin);
}

TEST(OpenCase, ItsSurfaceIsThatOfTheFileBitForBit) {
    const auto opened = openChanged("", "");
    ASSERT_TRUE(opened);
    const TriangleMesh& mesh = opened->teeth->outer()->mesh();
    const TriangleMesh block = test::box(Vec3(-3, -3, -6), Vec3(3, 3, 4));
    for (std::size_t t = 0; t < block.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) EXPECT_EQ(mesh.corner(t, corner), block.corner(t, corner));
    }
}

TEST(OpenCase, MistakesAreSaid) {
    const auto expectSaid = [](const Expected<OpenedCase>& opened, const std::string& said) {
        ASSERT_FALSE(opened);
        EXPECT_NE(opened.error().message().find(said), std::string::npos) << opened.error().message();
    };
    expectSaid(openChanged("bone.stl", "none.stl"), "x.ttcase: none.stl: there is no such file in the case.");
    expectSaid(openChanged("bone.stl", "case.toml"), "case.toml");
    expectSaid(openChanged("", "", "48"), "there is no tooth '48' in this case; it has 36, 37.");
}

TEST(OpenCase, MaterialsAndBurOfTheCaseAreRead) {
    auto files = test::blockCase();
    std::string text(asText(files[0].bytes));
    text = "materials = \"m.toml\"\n" + text + "\n[[bur]]\nfile = \"burs/mine.toml\"\n";
    files[0].bytes = bytesOf(text);
    files.push_back({"m.toml", bytesOf("[enamel]\nstiffness = 0.9\n")});
    files.push_back({"burs/mine.toml", bytesOf("surface = \"mine.stl\"\nmaterial = \"diamond\"\ngrit_um = 106\n"
                                               "sharpness = 0.5\n")});
    files.push_back({"burs/mine.stl", stlBytes(test::cylinder(Vec3::Zero(), 0.5, 4, 24))});
    const auto bytes = packCase(files).value();
    const auto opened = openCase(CaseStore::openArchive(bytes, "x.ttcase").value());
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_EQ(opened->teeth->materials()[test::kEnamel].numbers.stiffness, 0.9);
    ASSERT_TRUE(opened->bur);
    EXPECT_EQ(opened->bur->material, BurMaterial::Diamond);
    EXPECT_EQ(opened->bur->flutes, 0);
    EXPECT_EQ(opened->bur->gritMicrometres, 106);
    EXPECT_EQ(opened->bur->sharpness, 0.5);
}

/// A case with "composite" in place of dentin; its own materials file adds this material.
std::vector<CaseFile> compositeCase() {
    auto files = test::blockCase();
    std::string text = "materials = \"m.toml\"\n" + std::string(asText(files[0].bytes));
    for (std::size_t at = text.find("dentin ="); at != std::string::npos; at = text.find("dentin =", at))
        text.replace(at, 8, "composite =");
    files[0].bytes = bytesOf(text);
    files.push_back({"m.toml", bytesOf("[composite]\nstiffness = 0.7\nnesting = 6\n")});
    return files;
}

TEST(OpenCase, ItsOwnFileMayAddAMaterialThatALayerIsMadeOf) {
    const auto bytes = packCase(compositeCase()).value();
    const auto opened = openCase(CaseStore::openArchive(bytes, "x.ttcase").value());
    ASSERT_TRUE(opened) << opened.error().message();
    const MaterialRegistry& materials = opened->teeth->materials();
    const MaterialId at = opened->teeth->materialAt(Vec3(0, 0, 0));
    EXPECT_EQ(materials.nameOf(at), "composite");
    EXPECT_EQ(materials[at].numbers.stiffness, 0.7);
    EXPECT_NE(caseText(opened->description).find("composite = "), std::string::npos);
}

TEST(OpenCase, MaterialsThatAreGivenStandInForItsOwn) {
    const auto bytes = packCase(compositeCase()).value();
    const auto store = CaseStore::openArchive(bytes, "x.ttcase").value();
    const auto without = openCase(store, {}, &builtinMaterials());
    ASSERT_FALSE(without);
    EXPECT_NE(without.error().message().find("there is no material 'composite'; the materials are enamel, "),
              std::string::npos)
        << without.error().message();
    const auto other = parseMaterials("[composite]\nstiffness = 0.3\n", "m.toml");
    ASSERT_TRUE(other);
    const auto opened = openCase(store, {}, *other);
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_EQ(&opened->teeth->materials(), *other);
}

TEST(OpenCase, AMistakeInItsMaterialsIsSaidWithThatFile) {
    auto files = compositeCase();
    files.back().bytes = bytesOf("[enamel]\nstiffness = 9\n");
    const auto bytes = packCase(files).value();
    const auto opened = openCase(CaseStore::openArchive(bytes, "x.ttcase").value());
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().message().find("m.toml, line 2: 'stiffness' must be a number"), std::string::npos);
}

TEST(OpenCase, OverlapsAreFound) {
    std::vector<CaseBody> bodies = {{"a", test::box(Vec3(0, 0, 0), Vec3(4, 4, 4))},
                                    {"b", test::box(Vec3(3.5, 1, 1), Vec3(8, 3, 3))},
                                    {"c", test::box(Vec3(4, 0, 10), Vec3(8, 4, 14))}};
    const auto found = overlaps(bodies);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].first + found[0].second, "ab");
    EXPECT_NEAR(found[0].deepest, 0.5, 1e-9);
}

TEST(OpenCase, TheOthersAndWhatIsAroundAreNotTheToothThatIsWorkedOn) {
    const auto opened = openChanged("", "", "37");
    ASSERT_TRUE(opened) << opened.error().message();
    const CutModel piece(opened->teeth, 0.1);
    HapticSettings settings;
    HapticSimulation simulation(std::make_shared<const ToolShape>(test::cylinder(Vec3::Zero(), 0.5, 6, 24)), 0.5,
                                piece.contactSurface(), settings);
    const auto press = [&](const Vec3& top) {
        (void)simulation.step({{top + Vec3(0, 0, 1), Quat::Identity()}, 0, false}, 0.001);
        const Tick tick = simulation.step({{top - Vec3(0, 0, 0.2), Quat::Identity()}, 0, false}, 0.001);
        EXPECT_GT(tick.contact.triangles, 0);
        return tick.contact.around;
    };
    EXPECT_EQ(press(Vec3(0, 0, 4)), std::nullopt);
    EXPECT_EQ(press(Vec3(-10, 0, 3)), test::kEnamel);
    EXPECT_EQ(press(Vec3(-5, 0, -11)), test::kOther);
}

TEST(OpenCase, EveryToothOfACaseCanBeCut) {
    const test::TemporaryFolder folder;
    const auto bytes = packCase(test::blockCase()).value();
    ASSERT_TRUE(writeFile(folder / "x.ttcase", bytes));
    const auto tooth = loadModelOrCase({.outer = folder / "x.ttcase", .layers = {}}, "37", 0.1, 0.1);
    ASSERT_TRUE(tooth) << tooth.error().message();
    EXPECT_EQ(tooth->place.name, "Two blocks, 37");
    EXPECT_EQ(tooth->place.teethOfCase, (std::vector<std::string>{"36", "37"}));
    const auto tool = makeCuttingTool(test::cylinder(Vec3::Zero(), 0.5, 6, 24));
    ASSERT_TRUE(tool);
    for (const Vec3& top : {Vec3(0, 0, 4), Vec3(-10, 0, 3)}) {
        const auto removed = tooth->piece->sweep(*tool, {top + Vec3(0, 0, 1), Quat::Identity()},
                                                 {top - Vec3(0, 0, 2.96), Quat::Identity()});
        EXPECT_NEAR(removed[static_cast<std::size_t>(test::kEnamel)], 3.14159 * 0.25 * 2, 0.1);
        EXPECT_NEAR(removed[static_cast<std::size_t>(test::kDentin)], 3.14159 * 0.25 * 0.96, 0.1);
    }
    tooth->piece->refreshSurface();
    const auto cut = parseStl(stlBytes(visibleMesh(*tooth->piece->surface()).mesh), "cut");
    ASSERT_TRUE(cut);
    EXPECT_TRUE(reportOn(*cut).watertight());
}

}  // namespace
}  // namespace tactooth
