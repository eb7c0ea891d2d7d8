// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/practice_report.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "assessment/metric_table.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

std::string line(std::string_view quantity, double value, std::string_view unit) {
    return std::string(quantity) + ',' + numberText(value) + ',' + std::string(unit) + '\n';
}

std::string metricLines(const CavityProgress& cavity) {
    std::string lines;
    for (const Metric& metric : metricTable()) lines += line(metric.quantity, metric.shown(cavity), metric.shownUnit());
    return lines;
}

std::string materialLines(const MaterialVolumes& removed) {
    std::string lines;
    for (const MaterialId id : builtinMaterials().ids()) {
        lines += line(builtinMaterials().nameOf(id) + " removed", removed[static_cast<std::size_t>(id)], "mm^3");
    }
    return lines;
}

TEST(PracticeReport, TellsWhatWasDoneToATooth) {
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
    EXPECT_EQ(text,
              "quantity,value,unit\n"
              "tooth,\"Lower \"\"first\"\" molar, 46\",\n"
              "task,\"Pit\",\n"
              "time since the first contact,61.5,s\n" +
                  metricLines(cavity) + materialLines(removed) +
                  "of it beside the tooth,0.25,mm^3\n"
                  "first contact,1,times\n"
                  "dentin reached,0,times\n"
                  "pulp exposed,0,times\n"
                  "neighbour touched,2,times\n"
                  "gum or bone touched,0,times\n"
                  "cut beside the tooth,0,times\n"
                  "bur stalled,0,times\n"
                  "piece came loose,0,times\n");
}

TEST(PracticeReport, FreePracticeHasNoCavityToCompareWith) {
    const std::string text = practiceReportCsv({.tooth = "46", .events = {}});
    EXPECT_EQ(text.find("task"), std::string::npos);
    EXPECT_EQ(text.find("ideal"), std::string::npos);
    EXPECT_NE(text.find("enamel removed,0,mm^3"), std::string::npos);
}

}  // namespace
}  // namespace tactooth
