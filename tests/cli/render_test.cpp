// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures that the program writes, in the form that a user gets.
#include <algorithm>
#include <filesystem>

#include "cli/cli_test.h"
#include "geometry/io/stl_writer.h"
#include "support/shapes.h"
#include "support/test_data.h"
#include "view/camera/second_view.h"
#include "view/render/image.h"

namespace tactooth {
namespace {

using namespace test;

class RenderCommand : public ::testing::Test {
protected:
    RenderCommand() {
        EXPECT_TRUE(writeStl(sphere(Vec3::Zero(), 5, 48, 24), folder_ / "ball.stl").has_value());
        EXPECT_TRUE(writeStl(sphere(Vec3::Zero(), 4, 48, 24), folder_ / "smaller.stl").has_value());
    }
    [[nodiscard]] std::string out() const { return folder_ / "out.png"; }
    ProgramRun render(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"render", "--tooth", folder_ / "ball.stl", "--out", out()};
        if (std::ranges::find(more, "--size") == more.end()) arguments.insert(arguments.end(), {"--size", "160x120"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runTactooth(arguments);
    }
    /// The picture with these options, which must be accepted.
    [[nodiscard]] Image picture(const std::vector<std::string>& more) const {
        const ProgramRun run = render(more);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        auto image = readPng(out());
        EXPECT_TRUE(image) << image.error().message();
        return image ? *image : Image{};
    }
    [[nodiscard]] std::string refusal(const std::vector<std::string>& more) const {
        const ProgramRun run = render(more);
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_THAT(run.out, IsEmpty());
        EXPECT_FALSE(std::filesystem::exists(out()));
        return run.err;
    }

    TemporaryFolder folder_;
};

TEST_F(RenderCommand, WritesAPictureOfTheSizeAskedFor) {
    const Image image = picture({"--view", "buccal"});
    EXPECT_EQ(image.size, (ImageSize{160, 120}));
    EXPECT_NE(image.at(80, 60), image.at(2, 2));
}

TEST_F(RenderCommand, SaysWhatItWrote) { EXPECT_EQ(render({}).out, out() + ": ball.stl, 160 x 120\n"); }

TEST_F(RenderCommand, WithoutBackgroundOnlyTheToothIsOpaque) {
    const Image image = picture({"--no-background"});
    EXPECT_EQ(image.at(80, 60)[3], 255);
    EXPECT_EQ(image.at(2, 2)[3], 0);
}

TEST_F(RenderCommand, AClipPlaneTakesAHalfAway) {
    const Image image = picture({"--view", "buccal", "--clip", "mesial", "--no-background"});
    // From the buccal side, +x (mesial) is to the left.
    EXPECT_EQ(image.at(70, 60)[3], 0);
    EXPECT_EQ(image.at(90, 60)[3], 255);
}

TEST_F(RenderCommand, TransparentEnamelLetsTheBackgroundThrough) {
    const Image solid = picture({"--view", "buccal", "--no-background"});
    const Image glassy = picture({"--view", "buccal", "--transparent", "enamel=0.2", "--no-background"});
    EXPECT_EQ(solid.at(80, 60)[3], 255);
    EXPECT_LT(glassy.at(80, 60)[3], 80);
}

TEST_F(RenderCommand, WhatLiesOutsideTheTargetIsBlueAndWhatLiesInsideOrange) {
    const Image outside = picture({"--view", "buccal", "--target", folder_ / "smaller.stl", "--range", "2"});
    EXPECT_GT(outside.at(80, 60)[2], outside.at(80, 60)[0] + 30);
    ASSERT_TRUE(writeStl(sphere(Vec3::Zero(), 6, 48, 24), folder_ / "larger.stl").has_value());
    const Image inside = picture({"--view", "buccal", "--target", folder_ / "larger.stl", "--range", "2"});
    EXPECT_GT(inside.at(80, 60)[0], inside.at(80, 60)[2] + 30);
}

TEST_F(RenderCommand, WithinTheToleranceTheToothIsWhite) {
    ASSERT_TRUE(writeStl(sphere(Vec3::Zero(), 5.3, 48, 24), folder_ / "near.stl").has_value());
    const std::vector<std::string> common = {"--view", "buccal", "--target", folder_ / "near.stl", "--range", "2"};
    const auto yellow = [&](const std::string& tolerance) {
        std::vector<std::string> words = common;
        words.insert(words.end(), {"--tolerance", tolerance});
        const Image image = picture(words);
        return image.at(80, 60)[0] - image.at(80, 60)[2];
    };
    EXPECT_GT(yellow("0.2"), yellow("0.4") + 15) << "0.3 mm were cut too deep";
}

TEST_F(RenderCommand, AToleranceBeyondTheRangeHasASentence) {
    EXPECT_THAT(refusal({"--target", folder_ / "smaller.stl", "--tolerance", "0.5"}),
                HasSubstr("--tolerance 0.5 must be smaller than --range (0.5)"));
}

TEST_F(RenderCommand, TheGhostOfATargetTintsTheToothBlueWhereItLiesInIt) {
    TriangleMesh withVoid = sphere(Vec3(0, 0, 2), 1.5, 48, 24);
    for (Triangle& triangle : withVoid.triangles) std::swap(triangle[1], triangle[2]);
    append(withVoid, sphere(Vec3::Zero(), 5, 48, 24));
    ASSERT_TRUE(writeStl(withVoid, folder_ / "withVoid.stl").has_value());
    const std::vector<std::string> above{"--view", "occlusal", "--no-background"};
    std::vector<std::string> ghost = above;
    ghost.insert(ghost.end(), {"--target", folder_ / "withVoid.stl", "--ghost"});
    const Image plain = picture(above);
    const Image tinted = picture(ghost);
    EXPECT_LT(plain.at(80, 60)[2], plain.at(80, 60)[0]);
    EXPECT_GT(tinted.at(80, 60)[2], tinted.at(80, 60)[0] + 30);
    EXPECT_EQ(tinted.at(80, 60)[3], 255);
    EXPECT_EQ(tinted.at(60, 60), plain.at(60, 60)) << "beside the cavity";
}

TEST_F(RenderCommand, RefusesAGhostOfNothing) {
    EXPECT_THAT(refusal({"--target", folder_ / "ball.stl", "--ghost"}), HasSubstr("leaves nothing to cut"));
    EXPECT_THAT(refusal({"--ghost"}), HasSubstr("--target"));
}

TEST_F(RenderCommand, SideBySideShowsTheToothTwice) {
    const Image image = picture({"--stereo", "side-by-side", "--no-background"});
    EXPECT_EQ(image.at(40, 60)[3], 255);
    EXPECT_EQ(image.at(120, 60)[3], 255);
    EXPECT_EQ(image.at(80, 10)[3], 0);
}

TEST_F(RenderCommand, ASecondViewStandsInTheCornerAlone) {
    const Image one = picture({"--no-background"});
    const Image both = picture({"--no-background", "--second", "occlusal"});
    const CornerRectangle place = secondViewRectangle(one.size);
    std::size_t inCorner = 0, elsewhere = 0;
    for (int y = 0; y < one.size.height; ++y) {
        for (int x = 0; x < one.size.width; ++x) {
            if (one.at(x, y) == both.at(x, y)) continue;
            ++(x >= place.left && y < place.top + place.size.height ? inCorner : elsewhere);
        }
    }
    EXPECT_GT(inCorner, 100);
    EXPECT_EQ(elsewhere, 0);
}

TEST_F(RenderCommand, ATurntableWritesNumberedPictures) {
    ASSERT_EQ(render({"--turntable", "3"}).exitCode, 0);
    for (const char* name : {"out-000.png", "out-001.png", "out-002.png"}) {
        EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(RenderCommand, RefusesWhatItCannotMean) {
    EXPECT_THAT(refusal({"--size", "0x100"}), HasSubstr("'0x100' is not a size"));
    EXPECT_THAT(refusal({"--view", "upside"}), HasSubstr("'upside' is not a view"));
    EXPECT_THAT(refusal({"--clip", "left"}), HasSubstr("'left' is not a clip plane"));
    EXPECT_THAT(refusal({"--clip", "buccal=x"}), HasSubstr("'buccal=x' is not a clip plane"));
    EXPECT_THAT(refusal({"--transparent", "enamel=2"}), HasSubstr("'enamel=2' makes nothing transparent"));
    EXPECT_THAT(refusal({"--transparent", "gold=0.5"}), HasSubstr("'gold=0.5' makes nothing transparent"));
    EXPECT_THAT(refusal({"--at", "1,2"}), HasSubstr("'1,2' is not a point"));
    EXPECT_THAT(refusal({"--target", "nothing.stl"}), HasSubstr("nothing.stl"));
    EXPECT_THAT(refusal({"--fog", "2"}), HasSubstr("--fog"));
}

}  // namespace
}  // namespace tactooth
