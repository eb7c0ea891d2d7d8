// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/intersection_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "support/shapes.h"
#include "tooth/surface/surface_intersection.h"

namespace tactooth {
namespace {

std::vector<std::uint32_t> likely(const IntersectionFilter& filter, const std::array<Vec3f, 3>& corners) {
    std::vector<std::uint32_t> found;
    filter.forCandidates(corners, [&](std::uint32_t t) { found.push_back(t); });
    return found;
}

std::vector<std::uint32_t> crossing(const TriangleMesh& mesh, const std::vector<std::uint32_t>& among,
                                    const std::array<Vec3f, 3>& corners) {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t t : among) {
        const auto& [a, b, c] = mesh.triangles[t];
        const IntersectingFace base{{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, {a, b, c}};
        if (intersectionOf(base, {corners, {1, 2, 3}})) found.push_back(t);
    }
    return found;
}

/// Two of three triangles; the count is no multiple of eight.
std::vector<std::uint32_t> someOf(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> some;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (t % 3 != 1) some.push_back(t);
    }
    some.resize(some.size() / 8 * 8 - 3);
    return some;
}

TEST(IntersectionFilter, RejectsNoneThatCrossesAndPassesFewOthers) {
    const TriangleMesh ball = test::sphere(Vec3(7, -3, 11), 1, 48, 24);
    const std::vector<std::uint32_t> some = someOf(ball);
    const IntersectionFilter filter(ball, some);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-1.1F, 1.1F);
    std::uniform_real_distribution<float> size(-0.1F, 0.1F);
    std::size_t crossed = 0;
    std::size_t visited = 0;
    for (int i = 0; i < 8'000; ++i) {
        std::array<Vec3f, 3> corners;
        corners[0] = Vec3f(7, -3, 11) + Vec3f(place(random), place(random), place(random));
        for (int c = 1; c < 3; ++c) corners[c] = corners[0] + Vec3f(size(random), size(random), size(random));
        const std::vector<std::uint32_t> found = likely(filter, corners);
        const std::vector<std::uint32_t> expected = crossing(ball, some, corners);
        ASSERT_TRUE(std::ranges::is_sorted(found));
        ASSERT_TRUE(std::ranges::includes(found, expected));
        crossed += expected.size();
        visited += found.size();
    }
    EXPECT_GT(crossed, 500U);
    EXPECT_LT(visited, 3 * crossed);
}

TEST(IntersectionFilter, RejectsNoneThatTouchesInADegenerateWay) {
    std::mt19937 random(4);
    std::uniform_int_distribution<int> place(0, 3);
    for (const float scale : {1.0F, 0.1F, 1e-13F, 1e-25F}) {  // products of the last scales are too small for a float
        const auto point = [&] { return Vec3f(scale * Vec3f(place(random), place(random), place(random))); };
        TriangleMesh mesh;
        for (std::uint32_t t = 0; t < 99; ++t) {
            for (int c = 0; c < 3; ++c) mesh.vertices.push_back(point());
            mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
        std::vector<std::uint32_t> all(mesh.triangles.size());
        std::iota(all.begin(), all.end(), 0U);
        const IntersectionFilter filter(mesh, all);
        std::size_t crossed = 0;
        for (int i = 0; i < 500; ++i) {
            const std::array<Vec3f, 3> corners = {point(), point(), point()};
            const std::vector<std::uint32_t> expected = crossing(mesh, all, corners);
            ASSERT_TRUE(std::ranges::includes(likely(filter, corners), expected));
            crossed += expected.size();
        }
        EXPECT_GT(crossed, 1000U);
    }
}

TEST(IntersectionFilter, FarTrianglesAreRejected) {
    const TriangleMesh block = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    std::vector<std::uint32_t> all(block.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    const IntersectionFilter filter(block, all);
    EXPECT_TRUE(likely(filter, {Vec3f(1.01F, 1, 1), Vec3f(2, 1, 1), Vec3f(1.01F, 2, 2)}).empty());
    EXPECT_TRUE(likely(filter, {Vec3f(0.2F, 0.2F, 0.5F), Vec3f(0.8F, 0.2F, 0.5F), Vec3f(0.2F, 0.8F, 0.5F)}).empty());
}

TEST(IntersectionFilter, OfNoTrianglesNoneIsFound) {
    const IntersectionFilter filter({}, {});
    EXPECT_TRUE(filter.empty());
    EXPECT_TRUE(likely(filter, {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}).empty());
}

}  // namespace
}  // namespace tactooth
