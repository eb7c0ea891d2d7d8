// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/report_section.h"

#include <gmock/gmock.h>

#include "assessment/preparation/prepared_blocks.h"

namespace tactooth {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A cavity that is 0.4 mm too wide to buccal, against one of 4 x 3 mm and 2 mm depth.
Preparation wide() {
    return test::blockPreparation(test::blockWithBox(-2, 2, -1.5, 1.9, 3), test::blockWithBox(-2, 2, -1.5, 1.5, 3));
}

std::vector<ReportSection> sectionsOf(const Preparation& preparation, const std::optional<Vec3>& worst) {
    return reportSections(preparation, CutSurfaces(preparation), worst);
}

TEST(ReportSection, NameTheirSides) {
    const auto sections = sectionsOf(wide(), std::nullopt);
    ASSERT_EQ(sections.size(), 2U);
    EXPECT_EQ(sections[0].left, "distal");
    EXPECT_EQ(sections[0].right, "mesial");
    EXPECT_EQ(sections[0].title, "Section from distal to mesial");
    EXPECT_EQ(sections[1].title, "Section from lingual to buccal");
    Preparation left = wide();
    left.mesialX = -1;
    EXPECT_EQ(sectionsOf(left, std::nullopt)[0].right, "mesial");
    Preparation buccal = wide();
    buccal.axis = Vec3::UnitY();
    EXPECT_EQ(sectionsOf(buccal, std::nullopt)[1].title, "Section from occlusal to gingival");
}

TEST(ReportSection, HoldTheWholePreparation) {
    const auto sections = sectionsOf(wide(), std::nullopt);
    for (const ReportSection& section : sections) {
        EXPECT_EQ(section.prepared.size(), 1U);
        EXPECT_TRUE(section.prepared[0].closed);
        EXPECT_EQ(section.ideal.size(), 1U);
        EXPECT_TRUE(section.pulp.empty());
    }
    EXPECT_GT(sections[0].box.sizes().x(), 4 + 2);
    EXPECT_GT(sections[1].box.sizes().x(), 3.4 + 2);
}

TEST(ReportSection, GoThroughTheWorstPlaceWhereItCanBeSeen) {
    const auto sections = sectionsOf(wide(), Vec3(1.2, 1.9, 4));
    EXPECT_THAT(sections[0].title, Not(HasSubstr("deepest")));  // runs along the wall
    EXPECT_THAT(sections[1].title, HasSubstr("at the deepest error"));
}

TEST(ReportSection, AreDrawnAsWellFormedLines) {
    Preparation preparation = wide();
    const auto section = sectionsOf(preparation, std::nullopt)[0];
    const std::string svg = sectionSvg(section, 80);
    EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 80.0"));
    for (const char* words : {"distal", "mesial", "prepared", "ideal", "uncut", "1 mm"})
        EXPECT_THAT(svg, HasSubstr(words));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("pulp")));
    EXPECT_GT(sectionHeight(section, 80), 30);
}

TEST(ReportSection, AreInJapaneseToo) {
    const Preparation preparation = wide();
    const auto sections = reportSections(preparation, CutSurfaces(preparation), Vec3(1.2, 1.9, 4), Language::Japanese);
    EXPECT_EQ(sections[0].title, "遠心から近心への断面");
    EXPECT_EQ(sections[1].title, "舌側から頬側への断面（最も深い誤りの位置）");
    const std::string svg = sectionSvg(sections[0], 80, Language::Japanese);
    for (const char* words : {"遠心", "近心", "形成後", "理想", "形成前"}) EXPECT_THAT(svg, HasSubstr(words));
    EXPECT_THAT(svg, Not(HasSubstr("prepared")));
}

TEST(ReportSection, OfAnUncutToothShowTheIdealAlone) {
    const Preparation preparation =
        test::blockPreparation(test::blockWithBox(-2, 2, -1.5, 1.5, 5), test::blockWithBox(-2, 2, -1.5, 1.5, 3));
    const auto sections = sectionsOf(preparation, std::nullopt);
    EXPECT_GT(sections[0].box.sizes().x(), 5);
}

}  // namespace
}  // namespace tactooth
