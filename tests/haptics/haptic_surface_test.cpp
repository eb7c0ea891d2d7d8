// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/haptic_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "haptics/tool_proxy.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

std::shared_ptr<const Surface> blockUpTo(double top) {
    auto part = std::make_shared<const SurfacePart>(test::box(Vec3(-2, -2, -2), Vec3(2, 2, top)));
    return std::make_shared<const Surface>(Surface{std::move(part), nullptr, {}, 0});
}

std::shared_ptr<const ToolShape> ball() {
    return std::make_shared<const ToolShape>(test::sphere(Vec3(0, 0, 0.5), 0.5, 24, 12));
}

Pose at(double height) { return {Vec3(0.1, 0.2, height), Quat::Identity()}; }

TEST(HapticSurfaceBuilder, APrebuiltListGivesTheSameTickAsNone) {
    const auto tool = ball();
    ToolProxy prepared(tool, blockUpTo(0), ContactMode::Proxy);
    ToolProxy plain(tool, blockUpTo(0), ContactMode::Proxy);
    for (const double height : {0.1, 0.0, -0.02}) (void)prepared.follow(at(height)), (void)plain.follow(at(height));

    HapticSurfaceBuilder surfaces(tool, blockUpTo(0));
    HapticSurface* hapticSurface = surfaces.make(blockUpTo(-0.03), prepared.pose(), at(-0.03));
    EXPECT_GT(hapticSurface->near.clusters(), 0U);
    EXPECT_EQ(hapticSurface->reach, at(-0.03).position);
    prepared.setSurface(*hapticSurface);
    (void)plain.setSurface(blockUpTo(-0.03));
    for (const double height : {-0.025, -0.035, -0.05}) {
        const ProxyState one = prepared.follow(at(height));
        const ProxyState other = plain.follow(at(height));
        EXPECT_NEAR((one.proxy.position - other.proxy.position).norm(), 0, 1e-6) << height;
        EXPECT_EQ(one.contacts > 0, other.contacts > 0);
    }
}

TEST(HapticSurfaceBuilder, ReturnsTheOldestSurfaceToTheCaller) {
    const auto tool = ball();
    const auto old = blockUpTo(0);
    ToolProxy proxy(tool, old, ContactMode::Proxy);
    HapticSurfaceBuilder surfaces(tool, old);
    HapticSurface* hapticSurface = surfaces.make(blockUpTo(-1), at(0.1), at(0.1));
    proxy.setSurface(*hapticSurface);
    EXPECT_EQ(hapticSurface->surface, nullptr) << "the one before is kept as long as the tool might go back to it";
    surfaces.recycle(hapticSurface);
    EXPECT_EQ(surfaces.make(blockUpTo(-1.5), at(0.1), at(0.1)), hapticSurface) << "used again";
    proxy.setSurface(*hapticSurface);
    EXPECT_EQ(hapticSurface->surface, old);
}

TEST(HapticSurfaceBuilder, FindsAFreePoseForADeviceInsideTheTooth) {
    const auto tool = ball();
    const auto block = blockUpTo(0);
    ToolProxy proxy(tool, block, ContactMode::Proxy);
    proxy.deferPlacement();
    EXPECT_FALSE(proxy.follow(at(-0.1)).placed);

    HapticSurfaceBuilder surfaces(tool, block);
    EXPECT_EQ(surfaces.place(block, at(0.1)), nullptr) << "free: the tick finds that itself";
    HapticSurface* hapticSurface = surfaces.place(block, at(-0.1));
    ASSERT_NE(hapticSurface, nullptr);
    EXPECT_FALSE(proxy.setSurface(*hapticSurface)) << "the surface is the same";
    const ProxyState state = proxy.follow(at(-0.12));
    EXPECT_TRUE(state.placed);
    EXPECT_NEAR(state.offset.norm(), 0.12, 1e-6);

    surfaces.recycle(hapticSurface);
    hapticSurface = surfaces.place(block, at(-0.3));
    ASSERT_NE(hapticSurface, nullptr);
    const Vec3 held = proxy.pose().position;
    (void)proxy.setSurface(*hapticSurface);
    EXPECT_EQ(proxy.pose().position, held) << "a tool that has a place keeps it";
}

TEST(ToolProxy, ADeviceThatIsFreeAgainIgnoresTheFreePose) {
    const auto tool = ball();
    ToolProxy proxy(tool, blockUpTo(0), ContactMode::Proxy);
    proxy.deferPlacement();
    EXPECT_FALSE(proxy.follow(at(-0.1)).placed);
    EXPECT_TRUE(proxy.follow(at(0.1)).placed);
    EXPECT_EQ(proxy.follow(at(0.05)).offset, Vec3::Zero());
}

/// A hollow box around the ball, with walls at this distance from its axis.
std::shared_ptr<const Surface> room(double halfWidth, double height) {
    auto walls = test::box(Vec3(-halfWidth, -halfWidth, -0.1), Vec3(halfWidth, halfWidth, height));
    auto part = std::make_shared<const SurfacePart>(std::move(walls));
    return std::make_shared<const Surface>(Surface{std::move(part), nullptr, {}, 0, false});
}

TEST(ToolProxy, StaysInTheOldSurfaceWhereTheNewOneCatchesItOnAllSides) {
    const auto tool = ball();
    const auto wide = room(0.52, 3), narrow = room(0.49, 1.1), wider = room(0.53, 3);
    const auto handAt = [](double x, double z) { return Pose{Vec3(x, 0, z), Quat::Identity()}; };
    ToolProxy proxy(tool, wide, ContactMode::Proxy);
    for (const double x : {0.0, 0.0, 0.1}) (void)proxy.follow(handAt(x, 0.2));
    HapticSurfaceBuilder surfaces(tool, wide);
    const auto feel = [&](const std::shared_ptr<const Surface>& surface) {
        HapticSurface* hapticSurface = surfaces.make(surface, proxy.pose(), proxy.pose());
        proxy.setSurface(*hapticSurface);
        surfaces.recycle(hapticSurface);
    };
    const Vec3 held = proxy.pose().position;
    EXPECT_GT(held.x(), 0.015);
    feel(room(0.495, 1.1));  // no tick uses this one
    feel(narrow);
    for (int tick = 0; tick < 20; ++tick) {
        const ProxyState state = proxy.follow(handAt(0.1, 0.2));
        ASSERT_TRUE(state.placed) << tick;
        EXPECT_GT(state.contacts, 0) << tick;
        EXPECT_NEAR((state.proxy.position - held).norm(), 0, 1e-6) << tick;
        EXPECT_EQ(proxy.surface(), wide) << tick;
    }
    HapticSurface* list = surfaces.make(narrow, proxy.pose(), proxy.pose());
    EXPECT_FALSE(proxy.setSurface(*list)) << "another list of the surface that waits is no new surface";
    EXPECT_EQ(proxy.surface(), wide);
    surfaces.recycle(list);
    feel(wider);  // the cut goes on
    EXPECT_NEAR(proxy.follow(handAt(0.1, 0.2)).proxy.position.x(), held.x() + 0.01, 1e-4);
    EXPECT_EQ(proxy.surface(), wider);

    feel(narrow);
    (void)proxy.follow(handAt(0, 0.2));
    EXPECT_EQ(proxy.surface(), wider);
    for (int tick = 0; tick < 120; ++tick) (void)proxy.follow(handAt(0, 0.2 + 0.01 * tick));  // above the narrow one
    EXPECT_EQ(proxy.surface(), narrow) << "used as soon as the tool is free in it";
}

/// Sets a new surface that rises up to `rise` in a ball that rests on the old one, at 0, and continues for `seconds`.
/// Returns the height of the ball at each tick.
std::vector<double> heightsWhereTheFloorHasRisen(double rise, double seconds, double dt) {
    const auto tool = ball();
    const auto floor = blockUpTo(0);
    ToolProxy proxy(tool, floor, ContactMode::Proxy);
    for (const double height : {0.1, 0.0, -0.1}) (void)proxy.follow(at(height));
    HapticSurfaceBuilder surfaces(tool, floor);
    HapticSurface* hapticSurface = surfaces.make(blockUpTo(rise), proxy.pose(), proxy.pose());
    proxy.setSurface(*hapticSurface);
    surfaces.recycle(hapticSurface);
    std::vector<double> heights;
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
        heights.push_back(proxy.follow(at(-0.1), at(-0.1), dt).proxy.position.z());
    }
    return heights;
}

TEST(ToolProxy, MovesFartherOutOfASurfaceThatKeepsItCaught) {
    constexpr double kRise = 0.009;  // mm: more than a tool is moved at once
    const std::vector<double> heights = heightsWhereTheFloorHasRisen(kRise, 0.02, 0.001);
    EXPECT_NEAR(heights.front(), 0, 1e-6) << "at first it stays in the surface before";
    EXPECT_NEAR(heights.back(), kRise, 1e-6);
}

TEST(ToolProxy, RetriesANewSurfaceAfterTheSameTimeAtAnyRate) {
    const auto secondsUntilItIsUsed = [](double dt) {
        const std::vector<double> heights = heightsWhereTheFloorHasRisen(0.009, 0.1, dt);
        const auto hapticSurface = std::ranges::find_if(heights, [](double height) { return height > 1e-3; });
        return static_cast<double>(hapticSurface - heights.begin()) * dt;
    };
    const double slow = secondsUntilItIsUsed(1e-3);
    EXPECT_GT(slow, 0.004);
    EXPECT_NEAR(secondsUntilItIsUsed(0.25e-3), slow, 1e-3);
}

TEST(HapticSurfaceBuilder, CoversTheSlideOfTheToolBesidesTheCut) {
    const auto tool = ball();
    HapticSurfaceBuilder surfaces(tool, blockUpTo(0));
    constexpr double kPause = 0.004;  // s
    const Vec3 step(0.04, 0, 0);      // in each: 10 mm/s
    for (int call = 0; call < 3; ++call) {
        surfaces.watch(call * kPause, {at(0.01).position + call * step, Quat::Identity()});
    }
    const Pose now{at(0.01).position + 2 * step, Quat::Identity()};
    const Pose cut{now.position + Vec3(0, 0, -0.03), now.rotation};
    HapticSurface* hapticSurface = surfaces.make(blockUpTo(0), now, cut);
    EXPECT_LE(hapticSurface->near.deviation(cut.position), hapticSurface->near.contactMargin().around);
    EXPECT_LE(hapticSurface->near.deviation(now.position + 2 * step), hapticSurface->near.contactMargin().around)
        << "two updates further on";
    surfaces.recycle(hapticSurface);

    surfaces.watch(3 * kPause, {now.position + Vec3(50, 0, 0), now.rotation});  // no list reaches that far
    hapticSurface = surfaces.make(blockUpTo(0), now, now);
    EXPECT_LT(hapticSurface->near.contactMargin().along.norm(), 1);
    surfaces.recycle(hapticSurface);
}

/// A finely meshed ball under the tool: many triangles are near it.
std::shared_ptr<const Surface> fineBed() {
    auto part = std::make_shared<const SurfacePart>(test::sphere(Vec3(0.1, 0.2, -0.52), 0.5, 240, 160));
    return std::make_shared<const Surface>(Surface{std::move(part), nullptr, {}, 0});
}

TEST(HapticSurfaceBuilder, RebuildsWhereAToolIsAboutToLeaveTheLastList) {
    const auto tool = std::make_shared<const ToolShape>(test::sphere(Vec3(0, 0, 0.5), 0.5, 192, 96));
    const auto bed = fineBed();
    ToolProxy proxy(tool, bed, ContactMode::Proxy);
    for (const double height : {0.05, -0.015}) (void)proxy.follow(at(height));
    HapticSurfaceBuilder surfaces(tool, bed);
    surfaces.watch(0, proxy.pose());
    HapticSurface* first = surfaces.rebuild();
    ASSERT_NE(first, nullptr) << "a tool that only touches is in need of lists as well";
    ASSERT_GT(first->near.clusters(), 1000U) << "or a tick lists them itself";
    proxy.setSurface(*first);
    surfaces.recycle(first);

    int renewed = 0;
    const std::uint32_t ownListRebuilds = proxy.ownListRebuilds();
    for (int tick = 1; tick <= 100; ++tick) {
        const ProxyState state = proxy.follow({Vec3(0.1 + 0.002 * tick, 0.2, -0.06), Quat::Identity()});
        EXPECT_GT(state.contacts, 0);
        surfaces.watch(0.001 * tick, state.proxy, proxy.ownListRebuilds());
        HapticSurface* hapticSurface = surfaces.rebuild();
        if (hapticSurface == nullptr) continue;
        ++renewed;
        EXPECT_EQ(hapticSurface->surface, bed);
        proxy.setSurface(*hapticSurface);
        EXPECT_EQ(hapticSurface->surface, bed) << "the surface stays the same";
        surfaces.recycle(hapticSurface);
        EXPECT_LE(proxy.pose().position.z(), state.proxy.position.z()) << "a list moves nothing";
    }
    EXPECT_EQ(proxy.ownListRebuilds(), ownListRebuilds) << "no tick had to list for itself";
    EXPECT_GT(renewed, 3);
    EXPECT_LT(renewed, 50);
    for (int tick = 101; tick <= 120; ++tick) {
        surfaces.watch(0.001 * tick, proxy.pose(), ownListRebuilds);
        HapticSurface* hapticSurface = surfaces.rebuild();
        if (hapticSurface != nullptr) surfaces.recycle(hapticSurface);
        EXPECT_TRUE(tick <= 102 || hapticSurface == nullptr) << "a tool at rest needs no other list";
    }
}

TEST(HapticSurfaceBuilder, RebuildsAtOnceAfterTheServoThreadHadTo) {
    const auto tool = ball();
    HapticSurfaceBuilder surfaces(tool, blockUpTo(0));
    surfaces.watch(0, at(0.01));
    surfaces.recycle(surfaces.make(blockUpTo(0), at(0.01), at(0.01)));
    surfaces.watch(0.001, at(0.01), 0);
    EXPECT_EQ(surfaces.rebuild(), nullptr);
    surfaces.watch(0.002, at(0.01), 1);
    HapticSurface* hapticSurface = surfaces.rebuild();
    ASSERT_NE(hapticSurface, nullptr);
    surfaces.recycle(hapticSurface);
    surfaces.watch(0.003, at(0.01), 1);
    EXPECT_EQ(surfaces.rebuild(), nullptr) << "once";
}

TEST(HapticSurfaceBuilder, ReachesNoFartherThanTheToolMovesUntilTheNextList) {
    const auto tool = ball();
    HapticSurfaceBuilder surfaces(tool, blockUpTo(0));
    HapticSurface* hapticSurface = surfaces.make(blockUpTo(0), at(0), at(-0.5));
    const ContactMargin& margin = hapticSurface->near.contactMargin();
    EXPECT_LT(margin.along.z(), -0.03);
    EXPECT_LT(margin.length(), 0.15);
    EXPECT_EQ(hapticSurface->reach, at(-0.5).position);
    surfaces.recycle(hapticSurface);
}

// A bur in its cavity: the more triangles are near it, the shorter the list, or building it would take longer than it
// lasts.
TEST(HapticSurfaceBuilder, ListsAreShorterWhereMoreTrianglesAreNear) {
    const auto tool = std::make_shared<const ToolShape>(test::sphere(Vec3::Zero(), 0.5, 30, 12));
    const auto cavity = std::make_shared<const Surface>(
        Surface{std::make_shared<const SurfacePart>(test::sphere(Vec3::Zero(), 0.52, 80, 40)), nullptr, {}, 0});
    HapticSurfaceBuilder surfaces(tool, cavity);
    const Pose from{Vec3::Zero(), Quat::Identity()};
    const auto lengthIn = [&](const std::shared_ptr<const Surface>& surface) {
        HapticSurface* hapticSurface = surfaces.make(surface, from, {Vec3(0, 0, -0.1), Quat::Identity()});
        const double length = hapticSurface->near.contactMargin().length();
        EXPECT_LE(hapticSurface->near.clusters(), 1U << 14);
        surfaces.recycle(hapticSurface);
        return length;
    };
    const double wanted = lengthIn(blockUpTo(-1));
    const double first = lengthIn(cavity);
    double length = first;
    for (int i = 0; i < 5; ++i) length = lengthIn(cavity);
    EXPECT_LE(length, first);
    EXPECT_LT(length, 0.9 * wanted);
    for (int i = 0; i < 5; ++i) length = lengthIn(blockUpTo(-1));
    EXPECT_EQ(length, wanted);
}

TEST(ToolProxy, IsStillHeldWhereTheGoalIsShortOfTheDevice) {
    ToolProxy proxy(ball(), blockUpTo(0), ContactMode::Proxy);
    (void)proxy.follow(at(0.1));
    const ProxyState state = proxy.follow(at(0.05), at(0.08));
    EXPECT_NEAR(state.proxy.position.z(), 0.08, 1e-9);
    EXPECT_EQ(state.contacts, 1);
    EXPECT_NEAR(state.offset.z(), 0.03, 1e-9);
}

}  // namespace
}  // namespace tactooth
