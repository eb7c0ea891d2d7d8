// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/practice_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "assessment/metric_table.h"

namespace tactooth {
namespace {

/// The lines of the present metrics and materials are pinned, in their order. Each later metric or material adds a
/// line.
TEST(PracticeReport, ListsWhatWasDoneToATooth) {
    const std::vector<CutEvent> events = {{CutEventKind::FirstContact, 2, Vec3::Zero()},
                                          {CutEventKind::NeighbourTouched, 3, Vec3::Zero()},
                                          {CutEventKind::NeighbourTouched, 5, Vec3::Zero()}};
    const CavityProgress cavity{8, 6, 2, 0.25};
    const MaterialVolumes removed = {5, 2.5, 0, 0, 0, 0.5};
    const std::string text = practiceReportCsv({.tooth = "Lower \"first\" molar, 46",
                                                .task = "Pit",
                                                .seconds = 61.5,
                                                .cavity = cavity,
                                                .removed = removed,
                                                .beside = 0.25,
                                                .events = events});
    const std::vector<std::string> pinned = {"quantity,value,unit",
                                             "tooth,\"Lower \"\"first\"\" molar, 46\",",
                                             "task,\"Pit\",",
                                             "time since the first contact,61.5,s",
                                             "ideal cavity,8,mm^3",
                                             "of it cut,6,mm^3",
                                             "of it cut,75,%",
                                             "cut beyond it,2,mm^3",
                                             "deepest beyond it,0.25,mm",
                                             "likeness,75,%",
                                             "enamel removed,5,mm^3",
                                             "dentin removed,2.5,mm^3",
                                             "pulp removed,0,mm^3",
                                             "other removed,0,mm^3",
                                             "restoration removed,0,mm^3",
                                             "caries removed,0.5,mm^3",
                                             "of it beside the tooth,0.25,mm^3",
                                             "first contact,1,times",
                                             "dentin reached,0,times",
                                             "pulp near,0,times",
                                             "pulp exposed,0,times",
                                             "neighbour touched,2,times",
                                             "gum or bone touched,0,times",
                                             "cut beside the tooth,0,times",
                                             "bur stalled,0,times",
                                             "piece came loose,0,times"};
    std::size_t found = 0;
    std::vector<std::string> others;
    std::istringstream report(text);
    for (std::string line; std::getline(report, line);) {
        if (found < pinned.size() && line == pinned[found]) {
            ++found;
        } else {
            others.push_back(line);
        }
    }
    EXPECT_EQ(found, pinned.size()) << "missing: " << pinned[std::min(found, pinned.size() - 1)] << "\n" << text;
    constexpr std::size_t kPinnedMetrics = 6, kPinnedMaterials = 6;
    const auto materials = static_cast<std::size_t>(std::count_if(
        others.begin(), others.end(), [](const std::string& line) { return line.ends_with(" removed,0,mm^3"); }));
    EXPECT_EQ(materials, builtinMaterials().size() - kPinnedMaterials) << text;
    EXPECT_EQ(others.size() - materials, metricTable().size() - kPinnedMetrics) << text;
}

TEST(PracticeReport, FreePracticeHasNoCavityToCompareWith) {
    const std::string text = practiceReportCsv({.tooth = "46", .events = {}});
    EXPECT_EQ(text.find("task"), std::string::npos);
    EXPECT_EQ(text.find("ideal"), std::string::npos);
    EXPECT_NE(text.find("enamel removed,0,mm^3"), std::string::npos);
}

}  // namespace
}  // namespace tactooth
