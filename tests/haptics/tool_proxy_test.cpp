// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/tool_proxy.h"

#include <gtest/gtest.h>

#include <random>

#include "scene.h"
#include "support/materials.h"

namespace tactooth {
namespace {

using test::at;

constexpr double kRounding = 1e-6;  // mm: coordinates of a mesh are floats, and the proxy keeps a tiny margin

ToolProxy proxyAbove(const std::shared_ptr<const Surface>& surface, ContactMode mode = ContactMode::Proxy) {
    ToolProxy proxy(test::ball(), surface, mode);
    (void)proxy.follow(at(0, 0, 1));
    return proxy;
}

TEST(ToolProxy, InTheAirItIsAtTheDevice) {
    ToolProxy proxy(test::ball(), test::block(), ContactMode::Proxy);
    const ProxyState state = proxy.follow(at(0.3, 0.2, 0.5));
    EXPECT_TRUE(state.placed);
    EXPECT_EQ(state.contacts, 0);
    EXPECT_EQ(state.offset, Vec3::Zero());
    EXPECT_EQ(state.proxy.position, Vec3(0.3, 0.2, 0.5));
}

TEST(ToolProxy, OnAPlaneItStaysAboveTheDevice) {
    ToolProxy proxy = proxyAbove(test::block(test::kDentin));
    const ProxyState state = proxy.follow(at(0.1, 0.2, -0.4));
    EXPECT_TRUE(state.offset.isApprox(Vec3(0, 0, 0.4), kRounding));
    ASSERT_GT(state.contacts, 0);
    Vec3 sum = Vec3::Zero();
    for (const ContactPoint& held : state.contactPoints()) {
        EXPECT_EQ(held.material, test::kDentin);
        EXPECT_NEAR(held.point.z(), 0, kRounding);
        sum += held.multiplier * held.normal;
    }
    EXPECT_TRUE(sum.isApprox(state.offset, kRounding));
}

TEST(ToolProxy, TravelIsThatOfTheProxyAndNotOfTheDevice) {
    ToolProxy proxy = proxyAbove(test::block());
    (void)proxy.follow(at(0, 0, -0.1));
    EXPECT_NEAR(proxy.follow(at(0, 0, -0.3)).travel, 0, kRounding);
    EXPECT_NEAR(proxy.follow(at(0.2, 0, -0.3)).travel, 0.2, kRounding);
}

TEST(ToolProxy, NeverEntersTheToothOnARandomWalkThroughIt) {
    const auto surface = test::block();
    ToolProxy proxy = proxyAbove(surface);
    ContactQuery query(test::ball(), surface);
    std::mt19937 random(20260204);
    std::normal_distribution<double> step(0, 0.15);
    Pose hand = at(0, 0, 0.5);
    int touching = 0;
    for (int i = 0; i < 2000; ++i) {
        hand.position += Vec3(step(random), step(random), step(random));
        hand.position = hand.position.cwiseMax(Vec3(-6, -6, -1.5)).cwiseMin(Vec3(6, 6, 1));
        const ProxyState state = proxy.follow(hand);
        ASSERT_TRUE(state.placed);
        // The oracle's rounding error is some picometres: ask it a nanometre off the surface.
        const Vec3 off = state.contacts > 0 ? Vec3(1e-6 * state.offset.normalized()) : Vec3::Zero();
        ASSERT_TRUE(query.isFree({state.proxy.position + off, state.proxy.rotation})) << i;
        touching += state.contacts > 0;
    }
    EXPECT_GT(touching, 600);
    EXPECT_LT(touching, 1800);
}

TEST(ToolProxy, ADeviceThatStartsInsideGetsTheNearestFreePose) {
    ToolProxy proxy(test::ball(), test::block(), ContactMode::Proxy);
    const ProxyState state = proxy.follow(at(1, 1, -0.7));
    ASSERT_TRUE(state.placed);
    EXPECT_TRUE(state.offset.isApprox(Vec3(0, 0, 0.7), 1e-4)) << state.offset.transpose();
}

TEST(ToolProxy, ARisingSurfaceLiftsTheToolOutOfItself) {
    for (const double rise : {1e-5, 0.001, 0.1}) {
        ToolProxy proxy = proxyAbove(test::block());
        (void)proxy.follow(at(0, 0, -0.2));
        (void)proxy.setSurface(test::block(test::kEnamel, rise));
        const ProxyState state = proxy.follow(at(0, 0, -0.2));
        ASSERT_TRUE(state.placed) << rise;
        EXPECT_NEAR(state.offset.z(), 0.2 + rise, kRounding);
    }
}

TEST(ToolProxy, AnEnclosedToolGetsAFreePoseAtTheNextTick) {
    ToolProxy proxy = proxyAbove(test::block());
    (void)proxy.follow(at(0, 0, -0.2));
    for (const double top : {0.9, 2.5}) {  // the second contains the whole ball: no triangles meet
        (void)proxy.setSurface(test::block(test::kEnamel, top));
        EXPECT_FALSE(proxy.follow(at(0, 0, top - 0.7)).placed);
        const ProxyState state = proxy.follow(at(0, 0, top - 0.7));
        ASSERT_TRUE(state.placed);
        EXPECT_NEAR(state.offset.z(), 0.7, 1e-4);
    }
}

TEST(ToolProxy, SetSurfaceReturnsTheOldSurface) {
    auto first = test::block();
    ToolProxy proxy = proxyAbove(first);
    const std::shared_ptr<const Surface> old = proxy.setSurface(test::block());
    EXPECT_EQ(old, first);
    first.reset();
    EXPECT_EQ(old.use_count(), 1);
}

TEST(ToolProxy, AfterReleaseItFindsANewPose) {
    const auto surface = test::block();
    ToolProxy proxy = proxyAbove(surface);
    (void)proxy.follow(at(0, 0, -1));
    proxy.release();
    EXPECT_EQ(proxy.follow(at(0, 0, -7)).contacts, 0);  // below the block: the old history would hold it above
}

TEST(ToolProxy, AnOpenSurfaceIsTouchedToo) {
    auto open = std::make_shared<Surface>();
    TriangleMesh square;
    square.vertices = {Vec3f(-3, -3, 0), Vec3f(3, -3, 0), Vec3f(3, 3, 0), Vec3f(-3, 3, 0)};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    open->base = std::make_shared<const SurfacePart>(square);
    open->closed = false;
    ToolProxy proxy = proxyAbove(open);
    EXPECT_NEAR(proxy.follow(at(0, 0, -0.3)).offset.z(), 0.3, kRounding);
}

/// A square of `cells` by `cells` cells of 4 um.
std::shared_ptr<const Surface> denseSquare(int cells) {
    TriangleMesh mesh;
    for (int y = 0; y <= cells; ++y) {
        for (int x = 0; x <= cells; ++x) mesh.vertices.push_back(0.004F * Vec3f(x - 0.5F * cells, y - 0.5F * cells, 0));
    }
    const auto vertex = [&](int x, int y) { return static_cast<std::uint32_t>(y * (cells + 1) + x); };
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            mesh.triangles.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)});
            mesh.triangles.push_back({vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
        }
    }
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(std::move(mesh));
    surface->closed = false;
    return surface;
}

TEST(ToolProxy, AFlatToolIsHeldByAFlatFloorOfAnyResolution) {
    const auto tool = std::make_shared<const ToolShape>(test::cylinder(Vec3::Zero(), 0.4, 4, 32));
    for (const int cells : {50, 100, 250}) {  // the last gives more pairs than the solver can list
        ToolProxy proxy(tool, denseSquare(cells), ContactMode::Proxy);
        ProxyState state = proxy.follow(at(0.013, 0.017, 0.3));
        for (int i = 0; i < 20; ++i) {
            state = proxy.follow(at(0.013, 0.017, -0.1));
            if (i < 5) continue;
            ASSERT_GT(state.contacts, 0) << cells;
            ASSERT_NEAR(state.offset.z(), 0.1, 0.01) << cells;
        }
    }
}

TEST(ToolProxy, PenaltyModeFreesTheDeepestPairAndKeepsNoHistory) {
    const auto surface = test::block(test::kCaries);
    ToolProxy proxy = proxyAbove(surface, ContactMode::Penalty);
    ContactQuery query(test::ball(), surface);
    for (const double depth : {0.01, 0.05, 0.1}) {
        const ProxyState state = proxy.follow(at(0.1, 0.3, -depth));
        const Contact pair = query.deepestPairAt(at(0.1, 0.3, -depth));
        EXPECT_TRUE(state.placed);
        EXPECT_GT(state.offset.norm(), 0);
        EXPECT_EQ(state.offset, Vec3(pair.depth * pair.normal));
        EXPECT_EQ(state.contacts, pair.contacts);
        ASSERT_EQ(state.contactPointCount, 1);
        EXPECT_EQ(state.held[0].material, test::kCaries);
    }
    EXPECT_EQ(proxy.follow(at(0, 0, 0.5)).contacts, 0);
    EXPECT_EQ(proxy.follow(at(0, 0, -2)).offset, Vec3::Zero());  // wholly inside, no pair of triangles meets
}

}  // namespace
}  // namespace tactooth
