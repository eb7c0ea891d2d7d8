// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/tooth_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>

#include "bench_scene.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/byte_stream.h"
#include "support/materials.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::at;
using test::cutBlock;

const Provenance kNotes = {{"tooth", "block.stl"}, {"who", "a student of dentistry, 3rd year"}};

TEST(ToothFile, BringsBackEveryBit) {
    const auto piece = cutBlock();
    const test::TemporaryFolder folder;
    const auto path = folder / "cut.tactooth";
    ASSERT_TRUE(saveTooth(*piece, kNotes, path));
    const auto opened = openTooth(path);
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_EQ(opened->provenance, kNotes);
    const CutModel& again = *opened->piece;
    EXPECT_EQ(again.hash(), piece->hash());
    EXPECT_EQ(again.removed(), piece->removed());
    EXPECT_EQ(again.tooth().layers().size(), 2U);
    EXPECT_EQ(again.tooth().layers()[1].name, "core");
    const TaggedMesh before = visibleMesh(*piece->surface());
    const TaggedMesh after = visibleMesh(*again.surface());
    EXPECT_EQ(after.mesh.vertices, before.mesh.vertices);
    EXPECT_EQ(after.mesh.triangles, before.mesh.triangles);
    EXPECT_EQ(after.tags, before.tags);
    EXPECT_EQ(toothFileBytes(again, kNotes), toothFileBytes(*piece, kNotes));
}

TEST(ToothFile, AnOpenedToothIsCutOnAsIfItHadNeverBeenSaved) {
    const auto piece = cutBlock();
    const test::TemporaryFolder folder;
    ASSERT_TRUE(saveTooth(*piece, {}, folder / "cut.tactooth"));
    const auto opened = openTooth(folder / "cut.tactooth");
    ASSERT_TRUE(opened) << opened.error().message();
    const auto cutOn = [](CutModel& one) {
        return one.sweep(test::flatBur().cutting, at(0.5, 0.3, -0.5), at(-0.6, 0.4, -0.7));
    };
    const MaterialVolumes removed = cutOn(*piece);
    EXPECT_EQ(cutOn(*opened->piece), removed);
    EXPECT_GT(removed[static_cast<std::size_t>(test::kDentin)], 0.01);
    EXPECT_EQ(opened->piece->hash(), piece->hash());
}

TEST(ToothFile, AWholeToothIsSavedToo) {
    const auto piece = test::blockOnTheBench();
    const test::TemporaryFolder folder;
    ASSERT_TRUE(saveTooth(*piece, {}, folder / "whole.tactooth"));
    const auto opened = openTooth(folder / "whole.tactooth");
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_EQ(opened->piece->hash(), piece->hash());
    EXPECT_TRUE(opened->piece->surface()->patches.empty());
}

TEST(ToothFile, KnowsHowTheToothStandsAndWhatIsAroundIt) {
    TriangleMesh outer = test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0));
    append(outer, test::box(Vec3(3, -2, -3), Vec3(5, 2, 0)));
    std::vector<LayerMesh> layers;
    for (int i = 0; i < 100; ++i) {  // as many as a whole mouth has
        const double x = -1.9 + 0.03 * i;
        layers.push_back(
            {"layer " + std::to_string(i), test::kDentin, test::box(Vec3(x, -0.5, -2), Vec3(x + 0.02, 0.5, -1))});
    }
    auto tooth = LayeredTooth::make(outer, std::move(layers), test::kEnamel, {.mesialX = -1, .firstAdjacent = 12});
    ASSERT_TRUE(tooth) << tooth.error().message();
    const CutModel piece(std::make_shared<const LayeredTooth>(std::move(*tooth)), test::kVoxel);
    const test::TemporaryFolder folder;
    ASSERT_TRUE(saveTooth(piece, {}, folder / "x.tactooth"));
    const auto opened = openTooth(folder / "x.tactooth");
    ASSERT_TRUE(opened) << opened.error().message();
    const LayeredTooth& again = opened->piece->tooth();
    EXPECT_EQ(again.layers().size(), 100U);
    EXPECT_EQ(again.toothContext().mesialX, -1);
    EXPECT_EQ(again.ownBox().max(), Vec3(2, 2, 0));
    const Surface& contactSurface = *opened->piece->contactSurface();
    EXPECT_FALSE(contactSurface.base->isAdjacent(11));
    EXPECT_TRUE(contactSurface.base->isAdjacent(12));
}

/// A block of enamel with a restoration over decay, cut by 0.0618 and 0.0829 mm^3 and saved in format version 2.
std::filesystem::path oldFile() { return test::sourceFolder() / "tests/session/data/version-2.tactooth"; }

TEST(ToothFile, OfTheSecondVersionIsStillRead) {
    const auto opened = openTooth(oldFile());
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_TRUE(opened->importNotes.empty());
    const LayeredTooth& tooth = opened->piece->tooth();
    EXPECT_EQ(&tooth.materials(), &builtinMaterials());
    ASSERT_EQ(tooth.layers().size(), 3U);
    EXPECT_EQ(tooth.layers()[0].material, test::kEnamel);
    EXPECT_EQ(tooth.layers()[1].material, test::kRestoration);
    EXPECT_EQ(tooth.layers()[2].material, test::kCaries);
    const MaterialVolumes& removed = opened->piece->removed();
    EXPECT_EQ(removed[static_cast<std::size_t>(test::kEnamel)], 0.061851022540588774);
    EXPECT_EQ(removed[static_cast<std::size_t>(test::kRestoration)], 0.08293871344285701);
    EXPECT_EQ(total(removed), 0.061851022540588774 + 0.08293871344285701);
    EXPECT_FALSE(opened->piece->surface()->patches.empty());
}

TEST(ToothFile, OfTheSecondVersionIsSavedAgainAsTheNewOne) {
    const auto opened = openTooth(oldFile());
    ASSERT_TRUE(opened) << opened.error().message();
    const std::vector<std::byte> bytes = toothFileBytes(*opened->piece, opened->provenance);
    EXPECT_EQ(bytes[8], std::byte{3});
    const auto parsed = parseSavedTooth(bytes, "new");
    ASSERT_TRUE(parsed) << parsed.error().message();
    EXPECT_EQ(parsed->removed, opened->piece->removed());
    EXPECT_EQ(parsed->layers[1].material, test::kRestoration);
    EXPECT_EQ(parsed->cuts.size(), opened->piece->volume().cutBricks().size());
}

/// In version 1 the material of the rest was the last value before the volume.
TEST(ToothFile, OfTheFirstVersionIsStillRead) {
    const auto file = readFile(oldFile());
    ASSERT_TRUE(file);
    std::vector<std::byte> bytes(file->bytes().begin(), file->bytes().end());
    constexpr double kVoxel = 0.1;
    std::vector<std::byte> voxel(sizeof(double));
    std::memcpy(voxel.data(), &kVoxel, sizeof(double));
    const auto volume = std::search(bytes.begin(), bytes.end(), voxel.begin(), voxel.end());
    ASSERT_NE(volume, bytes.end());
    bytes.erase(volume - 5, volume);
    bytes[8] = std::byte{1};
    const std::uint64_t sum = checksum(std::span(bytes).first(bytes.size() - sizeof sum));
    std::memcpy(bytes.data() + bytes.size() - sizeof sum, &sum, sizeof sum);
    const auto parsed = parseSavedTooth(bytes, "old");
    ASSERT_TRUE(parsed) << parsed.error().message();
    EXPECT_EQ(parsed->cuts.size(), openTooth(oldFile()).value().piece->volume().cutBricks().size());
    EXPECT_EQ(parsed->layers[2].material, test::kCaries);
    EXPECT_EQ(parsed->toothContext.mesialX, 1);
    EXPECT_EQ(parsed->toothContext.firstAdjacent, UINT32_MAX);
}

TEST(ToothFile, SaysWhatIsWrongWithOtherFiles) {
    const test::TemporaryFolder folder;
    const auto refusal = [&](const std::string& bytes) {
        std::ofstream(folder / "x.tactooth", std::ios::binary) << bytes;
        const auto opened = openTooth(folder / "x.tactooth");
        return opened ? std::string("opened") : opened.error().message();
    };
    EXPECT_NE(refusal("solid tooth").find("no saved tooth"), std::string::npos);
    EXPECT_NE(refusal("").find("empty"), std::string::npos);
    const std::vector<std::byte> good = toothFileBytes(*cutBlock(), kNotes);
    std::string bytes(reinterpret_cast<const char*>(good.data()), good.size());
    EXPECT_EQ(refusal(bytes), "opened");
    EXPECT_NE(refusal(bytes.substr(0, bytes.size() - 1)).find("cut short"), std::string::npos);
    EXPECT_NE(refusal(bytes + "x").find("more in the file"), std::string::npos);
    bytes[8] = 9;
    EXPECT_NE(refusal(bytes).find("format version 9, and this program reads versions 1 to 5"), std::string::npos);
    EXPECT_NE(openTooth(folder / "missing").error().message().find("no such file"), std::string::npos);
}

TEST(ToothFile, KeepsTheWorkInVersionFourAndIsVersionThreeWithoutIt) {
    const auto piece = cutBlock();
    const std::vector<std::byte> bytes = toothFileBytes(*piece, kNotes, "work");
    EXPECT_EQ(bytes[8], std::byte{4});
    const auto opened = parseTooth(bytes, "tooth", builtinMaterials());
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_EQ(opened->work, "work");
    EXPECT_EQ(opened->piece->hash(), piece->hash());
    EXPECT_EQ(toothFileBytes(*piece, kNotes)[8], std::byte{3});
}

TEST(ToothFile, OneChangedByteAnywhereIsNoticed) {
    const std::vector<std::byte> good = toothFileBytes(*cutBlock(), kNotes, "work");
    std::mt19937 random(4);
    for (int i = 0; i < 300; ++i) {
        std::vector<std::byte> bytes = good;
        bytes[random() % bytes.size()] ^= static_cast<std::byte>(1 + random() % 255);
        const auto parsed = parseSavedTooth(bytes, "tooth");
        ASSERT_FALSE(parsed);
        EXPECT_TRUE(parsed.error().message().starts_with("tooth, byte "));
        EXPECT_TRUE(parsed.error().message().ends_with("."));
    }
}

TEST(ToothFile, NotesOfThisProgramAreAddedBehindThoseBefore) {
    const Provenance notes = savedNow(kNotes);
    ASSERT_EQ(notes.size(), kNotes.size() + 2);  // neither command nor path: a file may be given away
    EXPECT_EQ(notes[1], kNotes[1]);
    EXPECT_EQ(notes[2].first, "saved");
    EXPECT_EQ(notes[2].second.substr(0, 2), "20");
}

}  // namespace
}  // namespace tactooth
