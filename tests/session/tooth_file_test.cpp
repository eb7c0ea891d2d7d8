// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/tooth_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "bench_scene.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::at;

const Provenance kNotes = {{"tooth", "block.stl"}, {"who", "a student of dentistry, 3rd year"}};

/// A block with a core of dentin, cut into both.
std::shared_ptr<WorkPiece> cutBlock() {
    TriangleMesh outer = test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0));
    std::vector<LayerMesh> layers;
    layers.push_back({"enamel", MaterialId::Enamel, outer});
    layers.push_back({"core", MaterialId::Dentin, test::box(Vec3(-1, -1, -2), Vec3(1, 1, -0.3))});
    auto tooth = LayeredTooth::make(std::move(outer), std::move(layers));
    auto piece = std::make_shared<WorkPiece>(std::make_shared<const LayeredTooth>(std::move(*tooth)), test::kVoxel);
    piece->sweep(test::flatBur().cutting, at(0, 0, 0.2), at(0.1, 0, -0.6));
    piece->sweep(test::flatBur().cutting, at(0.1, 0, -0.6), at(0.5, 0.3, -0.5));
    piece->refreshSurface();
    return piece;
}

TEST(ToothFile, BringsBackEveryBit) {
    const auto piece = cutBlock();
    const test::TemporaryFolder folder;
    const auto path = folder / "cut.tactooth";
    ASSERT_TRUE(saveTooth(*piece, kNotes, path));
    const auto opened = openTooth(path);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(opened->provenance, kNotes);
    const WorkPiece& again = *opened->piece;
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
    ASSERT_TRUE(opened) << opened.error().message;
    const auto cutOn = [](WorkPiece& one) {
        return one.sweep(test::flatBur().cutting, at(0.5, 0.3, -0.5), at(-0.6, 0.4, -0.7));
    };
    const MaterialVolumes removed = cutOn(*piece);
    EXPECT_EQ(cutOn(*opened->piece), removed);
    EXPECT_GT(removed[static_cast<std::size_t>(MaterialId::Dentin)], 0.01);
    EXPECT_EQ(opened->piece->hash(), piece->hash());
}

TEST(ToothFile, AWholeToothIsSavedToo) {
    const auto piece = test::blockOnTheBench();
    const test::TemporaryFolder folder;
    ASSERT_TRUE(saveTooth(*piece, {}, folder / "whole.tactooth"));
    const auto opened = openTooth(folder / "whole.tactooth");
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(opened->piece->hash(), piece->hash());
    EXPECT_TRUE(opened->piece->surface()->patches.empty());
}

TEST(ToothFile, SaysWhatIsWrongWithOtherFiles) {
    const test::TemporaryFolder folder;
    const auto refusal = [&](const std::string& bytes) {
        std::ofstream(folder / "x.tactooth", std::ios::binary) << bytes;
        const auto opened = openTooth(folder / "x.tactooth");
        return opened ? std::string("opened") : opened.error().message;
    };
    EXPECT_NE(refusal("solid tooth").find("no saved tooth"), std::string::npos);
    EXPECT_NE(refusal("").find("empty"), std::string::npos);
    const std::vector<std::byte> good = toothFileBytes(*cutBlock(), kNotes);
    std::string bytes(reinterpret_cast<const char*>(good.data()), good.size());
    EXPECT_EQ(refusal(bytes), "opened");
    EXPECT_NE(refusal(bytes.substr(0, bytes.size() - 1)).find("cut short"), std::string::npos);
    EXPECT_NE(refusal(bytes + "x").find("more in the file"), std::string::npos);
    bytes[8] = 9;
    EXPECT_NE(refusal(bytes).find("format version 9"), std::string::npos);
    EXPECT_NE(openTooth(folder / "missing").error().message.find("no such file"), std::string::npos);
}

TEST(ToothFile, OneChangedByteAnywhereIsNoticed) {
    const std::vector<std::byte> good = toothFileBytes(*cutBlock(), kNotes);
    std::mt19937 random(4);
    for (int i = 0; i < 300; ++i) {
        std::vector<std::byte> bytes = good;
        bytes[random() % bytes.size()] ^= static_cast<std::byte>(1 + random() % 255);
        const auto parsed = parseSavedTooth(bytes, "tooth");
        ASSERT_FALSE(parsed);
        EXPECT_TRUE(parsed.error().message.starts_with("tooth, byte "));
        EXPECT_TRUE(parsed.error().message.ends_with("."));
    }
}

TEST(ToothFile, NotesOfThisProgramAreAddedBehindThoseBefore) {
    const Provenance notes = savedNow(kNotes);
    ASSERT_EQ(notes.size(), kNotes.size() + 3);
    EXPECT_EQ(notes[1], kNotes[1]);
    EXPECT_EQ(notes[2].first, "saved");
    EXPECT_EQ(notes[2].second.substr(0, 2), "20");
}

}  // namespace
}  // namespace tactooth
