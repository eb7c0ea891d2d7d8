// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth/valid_gingiva.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "instruments/mouth_layout.h"

namespace tactooth {
namespace {

TriangleMesh meshOf(int triangles) {
    TriangleMesh mesh;
    mesh.vertices.resize(3);
    mesh.triangles.resize(static_cast<std::size_t>(triangles), {0, 1, 2});
    return mesh;
}

TEST(ValidGingiva, IsThatOfTheFirstResolutionThatDoesNotCrossItself) {
    std::vector<double> cells;
    const auto gum = firstValidGingiva(
        0.4,
        [&](double cell) -> GingivaCandidate {
            cells.push_back(cell);
            return {meshOf(static_cast<int>(cells.size())), cells.size() < 3};
        },
        Message::verbatim("The gum"));
    ASSERT_TRUE(gum);
    EXPECT_EQ(gum->triangles.size(), 3U);
    EXPECT_EQ(cells.size(), 3U);
    EXPECT_EQ(cells[0], 0.4);
    EXPECT_LT(cells[2], cells[1]);
    EXPECT_LT(cells[1], cells[0]);
}

TEST(ValidGingiva, OneThatAlwaysCrossesItselfIsRefused) {
    int tries = 0;
    const auto gum = firstValidGingiva(
        0.4,
        [&](double) -> GingivaCandidate {
            return {meshOf(++tries), true};
        },
        Message::verbatim("The upper gum of the mouth with seed 5"));
    ASSERT_FALSE(gum);
    EXPECT_EQ(tries, 8);
    EXPECT_THAT(gum.error().message(), testing::StartsWith("The upper gum of the mouth with seed 5 crosses itself"));
    EXPECT_TRUE(gum.error().message().ends_with('.'));
}

TEST(ValidGingiva, AMouthWithoutASoundGumIsRefusedWithItsSentence) {
    const auto none = [](const MouthRequest&) -> Expected<MouthLayout> {
        return unexpected(Message::verbatim("It crosses itself."));
    };
    const auto noTooth = [](const ToothRequest&) { return BuiltinTooth(); };
    const auto mouth = makeMouth({.missing = {}}, noTooth, none);
    ASSERT_FALSE(mouth);
    EXPECT_EQ(mouth.error().message(), "It crosses itself.");
}

}  // namespace
}  // namespace tactooth
