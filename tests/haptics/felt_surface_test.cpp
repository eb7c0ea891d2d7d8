// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/felt_surface.h"

#include <gtest/gtest.h>

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

TEST(FeltSurfaces, ATickOnTheListMadeAheadEndsWhereOneWithoutItEnds) {
    const auto tool = ball();
    ToolProxy prepared(tool, blockUpTo(0), ContactMode::Proxy);
    ToolProxy plain(tool, blockUpTo(0), ContactMode::Proxy);
    for (const double height : {0.1, 0.0, -0.02}) (void)prepared.follow(at(height)), (void)plain.follow(at(height));

    FeltSurfaces surfaces(*tool);
    FeltSurface* felt = surfaces.make(blockUpTo(-0.03), prepared.pose(), at(-0.03));
    EXPECT_GT(felt->near.clusters(), 0U);
    EXPECT_EQ(felt->reach, at(-0.03).position);
    prepared.setSurface(*felt);
    (void)plain.setSurface(blockUpTo(-0.03));
    for (const double height : {-0.025, -0.035, -0.05}) {
        const ProxyState one = prepared.follow(at(height));
        const ProxyState other = plain.follow(at(height));
        EXPECT_NEAR((one.proxy.position - other.proxy.position).norm(), 0, 1e-6) << height;
        EXPECT_EQ(one.contacts > 0, other.contacts > 0);
    }
}

TEST(FeltSurfaces, LeavesTheOldSurfaceToWhoeverHandedOverTheNewOne) {
    const auto tool = ball();
    const auto old = blockUpTo(0);
    ToolProxy proxy(tool, old, ContactMode::Proxy);
    FeltSurfaces surfaces(*tool);
    FeltSurface* felt = surfaces.make(blockUpTo(-1), at(0.1), at(0.1));
    proxy.setSurface(*felt);
    EXPECT_EQ(felt->surface, old);
    surfaces.giveBack(felt);
    EXPECT_EQ(surfaces.make(old, at(0.1), at(0.1)), felt);  // used again
}

TEST(ToolProxy, ThatShallNotGoAllTheWayToTheHandIsStillHeld) {
    ToolProxy proxy(ball(), blockUpTo(0), ContactMode::Proxy);
    (void)proxy.follow(at(0.1));
    const ProxyState state = proxy.follow(at(0.05), at(0.08));
    EXPECT_NEAR(state.proxy.position.z(), 0.08, 1e-9);
    EXPECT_EQ(state.contacts, 1);
    EXPECT_NEAR(state.offset.z(), 0.03, 1e-9);
}

}  // namespace
}  // namespace tactooth
