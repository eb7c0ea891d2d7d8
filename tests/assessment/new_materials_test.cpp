// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Two materials that the program does not know, from a TOML text: they are touched, cut, counted, heard, saved,
// exported and scored like the built-in ones. tests/app/scene_builder_test.cpp shows that they are drawn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "assessment/practice_report.h"
#include "geometry/util/byte_stream.h"
#include "session/audio/tick_sound.h"
#include "session/bench_scene.h"
#include "session/io/material_file.h"
#include "session/simulation/tooth_file.h"
#include "support/materials.h"
#include "support/servo_tick.h"
#include "support/test_data.h"
#include "tooth/file/remaining_layers.h"

namespace tactooth {
namespace {

using test::at;
using ::testing::HasSubstr;

constexpr const char* kText = R"(
[composite]
stiffness = 0.7
removal = 0.02
nesting = 6
sound_centre = 5200
sound_level = 0.85

[amalgam]
stiffness = 0.9
removal = 0.012
nesting = 7
sound_centre = 8200
sound_level = 1.0
)";

using test::kTick;

/// A block of enamel with two fillings in its top, side by side: composite on the left, amalgam on the right.
class NewMaterials : public ::testing::Test {
protected:
    [[nodiscard]] MaterialId idOf(const char* name) const { return materials_.find(name).value(); }
    [[nodiscard]] double removed(const MaterialVolumes& volumes, const char* name) const {
        return volumes[static_cast<std::size_t>(idOf(name))];
    }
    /// The tick in which a bur at rest presses 0.2 mm into the top at x.
    [[nodiscard]] Tick pressedAt(double x) const {
        const Instrument bur = test::flatBur();
        HapticSettings settings;
        settings.materials = MaterialTable(materials_);
        HapticSimulation simulation(bur.shape, test::kBurRadius, piece_->surface(), settings);
        static_cast<void>(simulation.step({at(x, 0, 0.2), 0, false}, kTick));
        return simulation.step({at(x, 0, -0.2), 0, false}, kTick);
    }
    /// Through both fillings, 0.3 mm deep.
    MaterialVolumes cutBoth() {
        static_cast<void>(piece_->sweep(test::flatBur().cutting, at(-1, 0, 0.2), at(-1, 0, -0.3)));
        static_cast<void>(piece_->sweep(test::flatBur().cutting, at(-1, 0, -0.3), at(1, 0, -0.3)));
        piece_->refreshSurface();
        return piece_->removed();
    }

    const MaterialRegistry& materials_ = **parseMaterials(kText, "mine.toml");
    std::shared_ptr<CutModel> piece_ = [&] {
        TriangleMesh outer = test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0));
        std::vector<LayerMesh> layers;
        layers.push_back({"enamel", test::kEnamel, outer});
        layers.push_back({"composite", idOf("composite"), test::box(Vec3(-1.8, -1, -1), Vec3(0, 1, 0))});
        layers.push_back({"amalgam", idOf("amalgam"), test::box(Vec3(0, -1, -1), Vec3(1.8, 1, 0))});
        auto tooth = LayeredTooth::make(std::move(outer), std::move(layers), test::kEnamel, {}, materials_);
        return std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), test::kVoxel);
    }();
};

TEST_F(NewMaterials, AreTouchedWithTheirOwnStiffness) {
    EXPECT_EQ(pressedAt(-1).contact.material, idOf("composite"));
    EXPECT_NEAR(pressedAt(-1).force.stiffness, 0.7, 1e-9);
    EXPECT_EQ(pressedAt(1).contact.material, idOf("amalgam"));
    EXPECT_NEAR(pressedAt(1).force.stiffness, 0.9, 1e-9);
}

TEST_F(NewMaterials, AreHeardInTheirOwnBand) {
    const auto heardAt = [&](double x) {
        return soundOf(pressedAt(x), spindlePresets().front(), MaterialTable(materials_)).material;
    };
    EXPECT_EQ(heardAt(-1).bandCentreHz, 5200);
    EXPECT_EQ(heardAt(-1).level, 0.85);
    EXPECT_EQ(heardAt(1).bandCentreHz, 8200);
}

TEST_F(NewMaterials, AreCutByTheirOwnRemovalAndCountedApart) {
    const MaterialVolumes volumes = cutBoth();
    const double slot = 2 * test::kBurRadius * 0.3;  // mm^3 for each mm of its length
    const double end = std::numbers::pi * test::kBurRadius * test::kBurRadius / 2 * 0.3;
    EXPECT_NEAR(removed(volumes, "composite"), slot + end, 0.05 * slot);
    EXPECT_NEAR(removed(volumes, "amalgam"), slot + end, 0.05 * slot);
    EXPECT_NEAR(removed(volumes, "enamel"), 0, 0.05 * slot);
    const double work = workFor(volumes, MaterialTable(materials_), 1);
    EXPECT_NEAR(
        work,
        removed(volumes, "composite") / 0.02 + removed(volumes, "amalgam") / 0.012 + removed(volumes, "enamel") / 0.01,
        1e-9);
}

TEST_F(NewMaterials, AreThereAgainInASavedTooth) {
    const MaterialVolumes before = cutBoth();
    const test::TemporaryFolder folder;
    ASSERT_TRUE(saveTooth(*piece_, {}, folder / "filled.tactooth"));
    const auto opened = openTooth(folder / "filled.tactooth", &materials_);
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_TRUE(opened->importNotes.empty());
    EXPECT_EQ(&opened->piece->tooth().materials(), &materials_);
    EXPECT_EQ(opened->piece->removed(), before);
    EXPECT_EQ(opened->piece->hash(), piece_->hash());
    EXPECT_EQ(opened->piece->tooth().layers()[2].material, idOf("amalgam"));
}

TEST_F(NewMaterials, AreFoundByNameWhereTheirCodesHaveChanged) {
    const MaterialVolumes before = cutBoth();
    const test::TemporaryFolder folder;
    ASSERT_TRUE(saveTooth(*piece_, {}, folder / "filled.tactooth"));
    const auto others = parseMaterials("[gold]\n[amalgam]\n[composite]\n", "others.toml");
    ASSERT_TRUE(others);
    const auto opened = openTooth(folder / "filled.tactooth", *others);
    ASSERT_TRUE(opened) << opened.error().message();
    const MaterialRegistry& now = opened->piece->tooth().materials();
    EXPECT_EQ(&now, *others);
    const MaterialVolumes& after = opened->piece->removed();
    EXPECT_EQ(after[static_cast<std::size_t>(now.find("amalgam").value())], removed(before, "amalgam"));
    EXPECT_EQ(after[static_cast<std::size_t>(now.find("composite").value())], removed(before, "composite"));
}

TEST_F(NewMaterials, KeepTheirNamesAndNumbersWhereNobodyKnowsThem) {
    cutBoth();
    const test::TemporaryFolder folder;
    ASSERT_TRUE(saveTooth(*piece_, {}, folder / "filled.tactooth"));
    const auto opened = openTooth(folder / "filled.tactooth");
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_TRUE(opened->importNotes.empty());
    const MaterialRegistry& now = opened->piece->tooth().materials();
    const MaterialId composite = now.find("composite").value();
    EXPECT_EQ(now[composite], materials_[idOf("composite")]);
    EXPECT_EQ(now[now.find("amalgam").value()].numbers, materials_[idOf("amalgam")].numbers);
    EXPECT_GT(opened->piece->removed()[static_cast<std::size_t>(composite)], 0.1);
    EXPECT_EQ(toothFileBytes(*opened->piece, {}).size(), toothFileBytes(*piece_, {}).size());
}

/// The bytes of a file of version 5 as version 3 had them, without descriptions of materials.
std::vector<std::byte> asBeforeDescriptions(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    ByteWriter out;
    out.putAll(in.getBytes(8));
    EXPECT_EQ(in.get<std::uint32_t>(), 5U);
    out.put(std::uint32_t{3});
    const auto copyCount = [&] {
        const auto count = in.get<std::uint32_t>();
        out.put(count);
        return count;
    };
    for (std::uint32_t left = 2 * copyCount(); left > 0; --left) out.putText(in.getText());
    EXPECT_EQ(in.getText(), "");
    for (std::uint32_t left = copyCount(); left > 0; --left) {
        out.put(in.get<std::uint8_t>());
        out.putText(in.getText());
        if (in.get<std::uint8_t>() == 0) continue;
        for (int text = 0; text < 3; ++text) in.getText();  // titles and role
        in.getBytes(sizeof(std::int32_t) + 3 * sizeof(float));
        for (auto numbers = in.get<std::uint32_t>(); numbers > 0; --numbers) in.getText(), in.get<double>();
    }
    out.putAll(in.getBytes(in.left() - sizeof(std::uint64_t)));
    EXPECT_TRUE(in.ok());
    out.put(checksum(out.bytes()));
    return out.take();
}

TEST_F(NewMaterials, AreTakenAsBoneInAnOldFileThatDoesNotDescribeThem) {
    cutBoth();
    const auto opened =
        parseTooth(asBeforeDescriptions(toothFileBytes(*piece_, {})), "old.tactooth", builtinMaterials());
    ASSERT_TRUE(opened) << opened.error().message();
    ASSERT_EQ(opened->importNotes.size(), 2U);
    EXPECT_THAT(inWords(opened->importNotes.front()), HasSubstr("'composite' of this tooth is not known here"));
    const MaterialRegistry& now = opened->piece->tooth().materials();
    const MaterialId composite = now.find("composite").value();
    EXPECT_EQ(now[composite].numbers, builtinMaterials()[test::kOther].numbers);
    EXPECT_GT(opened->piece->removed()[static_cast<std::size_t>(composite)], 0.1);
}

TEST_F(NewMaterials, AreRefusedInADamagedDescription) {
    std::vector<std::byte> bytes = toothFileBytes(*piece_, {});
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t at = text.find("stiffness") + 9;
    ASSERT_LT(at, bytes.size());
    const double wild = 50;  // N/mm: more than any hand should feel
    std::memcpy(bytes.data() + at, &wild, sizeof(wild));
    const std::uint64_t sum = checksum(std::span(bytes).first(bytes.size() - sizeof(std::uint64_t)));
    std::memcpy(bytes.data() + bytes.size() - sizeof(sum), &sum, sizeof(sum));
    const auto opened = parseTooth(bytes, "wild.tactooth", builtinMaterials());
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().message(), HasSubstr("wild.tactooth"));
}

TEST_F(NewMaterials, AreExportedLayerByLayer) {
    const MaterialVolumes volumes = cutBoth();
    const std::vector<RemainingLayer> layers = remainingLayers(piece_->volume());
    ASSERT_EQ(layers.size(), 3U);
    EXPECT_EQ(layers[1].name, "composite");
    EXPECT_EQ(layers[2].name, "amalgam");
    const auto volumeOf = [](const TriangleMesh& mesh) {
        double sixfold = 0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            sixfold += mesh.corner(t, 0).dot(mesh.corner(t, 1).cross(mesh.corner(t, 2)));
        return sixfold / 6;
    };
    EXPECT_NEAR(volumeOf(layers[1].mesh), 3.6 - removed(volumes, "composite"), 0.02);
    EXPECT_NEAR(volumeOf(layers[2].mesh), 3.6 - removed(volumes, "amalgam"), 0.02);
}

TEST_F(NewMaterials, AreLinesOfTheReport) {
    PracticeReport report;
    report.removed = cutBoth();
    report.materials = &materials_;
    const std::string text = practiceReportCsv(report);
    EXPECT_THAT(text, HasSubstr("\ncomposite removed,0."));
    EXPECT_THAT(text, HasSubstr("\namalgam removed,0."));
}

}  // namespace
}  // namespace tactooth
