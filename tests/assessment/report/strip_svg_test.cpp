// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/strip_svg.h"

#include <gmock/gmock.h>

namespace tactooth {
namespace {

using testing::HasSubstr;
using testing::Not;

WorkStrip someStrip() {
    WorkStrip strip{.seconds = 90, .columns = {}, .marks = {}};
    for (int i = 0; i < 30; ++i) strip.columns.push_back({.force = 0.1 * i, .depth = i < 15 ? 0.0 : 1.8});
    strip.marks = {{10, "first contact"}, {11, "dentin reached"}, {60, "0.42 mm too deep", true}};
    return strip;
}

TEST(StripSvg, DrawsBothCurvesTheTimeAndTheMarks) {
    const std::string svg = stripSvg(someStrip(), 182, 40);
    for (const char* words : {"force, N", "depth, mm", ">0:00<", ">1:30<", ">1<", ">2<", ">3<", "#b23a24"}) {
        EXPECT_THAT(svg, HasSubstr(words));
    }
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(StripSvg, OfNothingIsAnEmptyPlot) {
    const std::string svg = stripSvg({.seconds = 0, .columns = {{}}, .marks = {}}, 182, 40);
    EXPECT_THAT(svg, HasSubstr("force, N"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace tactooth
