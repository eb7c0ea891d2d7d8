// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/practice_report.h"

#include <gtest/gtest.h>

#include <vector>

namespace tactooth {
namespace {

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
              "time since the first contact,61.5,s\n"
              "ideal cavity,8,mm^3\n"
              "of it cut,6,mm^3\n"
              "of it cut,75,%\n"
              "cut beyond it,2,mm^3\n"
              "deepest beyond it,0.25,mm\n"
              "likeness,75,%\n"
              "enamel removed,5,mm^3\n"
              "dentin removed,2.5,mm^3\n"
              "pulp removed,0,mm^3\n"
              "other removed,0,mm^3\n"
              "restoration removed,0,mm^3\n"
              "caries removed,0.5,mm^3\n"
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
