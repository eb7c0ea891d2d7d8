// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/import_note_translation.h"

#include <gtest/gtest.h>

#include "patient/scan_import.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

/// Whatever is said about a scan, the window has words for it.
void expectAllKnown(const Scan& scan, const ImportOptions& choices) {
    const auto examined = examineScan(scan, choices);
    ASSERT_TRUE(examined) << examined.error().message;
    const auto tooth = finishScan(*examined, choices);
    ASSERT_TRUE(tooth) << tooth.error().message;
    for (const ImportNote& importNote : tooth->importNotes) EXPECT_TRUE(isKnown(importNote)) << importNote.text;
}

TEST(ImportNoteTranslation, EveryImportNoteIsKnown) {
    const TriangleMesh block = test::box(Vec3(-3, -3, -12), Vec3(3, 3, 8));
    TriangleMesh damaged = block;
    std::swap(damaged.triangles[3][0], damaged.triangles[3][1]);
    damaged.triangles.push_back(damaged.triangles[0]);
    append(damaged, test::box(Vec3(9, 9, 9), Vec3(9.1, 9.1, 9.1)));
    damaged.triangles.erase(damaged.triangles.begin() + 6);
    ImportOptions all;
    all.holes = HolesToFill::All;
    expectAllKnown({"a", block, {}}, {});
    expectAllKnown({"a", damaged, {}}, all);
    ImportOptions chosen;
    chosen.mmPerUnit = 1.1;
    chosen.frame.isFlipped = true;
    chosen.frame.turn = 1;
    chosen.modelsLayers = false;
    expectAllKnown({"a", block, {}}, chosen);
    TriangleMesh huge = block;
    for (Vec3f& vertex : huge.vertices) vertex *= 7;
    expectAllKnown({"a", huge, {}}, {});
    const std::vector<LayerMesh> layers = {{"dentin", test::kDentin, test::box(Vec3(-3, -3, -12), Vec3(3, 3, 0))},
                                           {"enamel", test::kEnamel, test::box(Vec3(-3, -3, 0), Vec3(3, 3, 8))}};
    expectAllKnown({"a", {}, layers}, {});
    expectAllKnown({"a", block, {layers.front()}}, {});
}

TEST(ImportNoteTranslation, ValuesStandInTheirPlaces) {
    EXPECT_EQ(translated(ImportNote{
                  ImportNoteTopic::Closedness, "%1: %2 crumbs beside the surface were dropped.", {"x", "7"}}),
              QString("x: 7 crumbs beside the surface were dropped."));
}

}  // namespace
}  // namespace tactooth
