// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/prepared_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/shapes.h"

namespace tactooth::test {
namespace {

void addCorners(TriangleMesh& mesh, const Rectangle& r) {
    for (const Vec3& corner : {Vec3(r.left, r.back, r.leftHeight), Vec3(r.right, r.back, r.rightHeight),
                               Vec3(r.right, r.front, r.rightHeight), Vec3(r.left, r.front, r.leftHeight)}) {
        mesh.vertices.push_back(corner.cast<float>());
    }
}

}  // namespace

TriangleMesh preparedBlock(double top, const Rectangle& opening, const Rectangle& end) {
    TriangleMesh mesh;
    addCorners(mesh, Rectangle::level(-5, 5, -5, 5, -5));
    addCorners(mesh, Rectangle::level(-5, 5, -5, 5, top));
    addCorners(mesh, opening);
    addCorners(mesh, end);
    const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    };
    face(0, 3, 2, 1);
    face(12, 13, 14, 15);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t next = (i + 1) % 4;
        face(i, next, 4 + next, 4 + i);
        face(4 + i, 4 + next, 8 + next, 8 + i);
        face(8 + i, 8 + next, 12 + next, 12 + i);
    }
    return mesh;
}

TriangleMesh blockWithBox(double left, double right, double back, double front, double floor) {
    return blockWithCavityTo(Rectangle::level(left, right, back, front, 5),
                             Rectangle::level(left, right, back, front, floor));
}

TriangleMesh blockWithFloorProfile(const std::vector<Vec2>& profile) {
    TriangleMesh mesh;
    addCorners(mesh, Rectangle::level(-5, 5, -5, 5, -5));
    addCorners(mesh, Rectangle::level(-5, 5, -5, 5, 5));
    for (const Vec2& at : profile) {  // of each: the opening behind, the floor behind and in front, the opening there
        for (const Vec3& corner :
             {Vec3(at.x(), -1.5, 5), Vec3(at.x(), -1.5, at.y()), Vec3(at.x(), 1.5, at.y()), Vec3(at.x(), 1.5, 5)})
            mesh.vertices.push_back(corner.cast<float>());
    }
    const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    };
    face(0, 3, 2, 1);
    for (std::uint32_t i = 0; i < 4; ++i) face(i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i);
    constexpr std::uint32_t kFirst = 8;
    const std::uint32_t last = kFirst + 4 * (static_cast<std::uint32_t>(profile.size()) - 1);
    for (std::uint32_t i = kFirst; i < last; i += 4) {
        mesh.triangles.insert(mesh.triangles.end(), {{4, i + 4, i}, {7, i + 3, i + 7}});
        for (std::uint32_t k = 0; k < 3; ++k) face(i + k, i + 4 + k, i + 5 + k, i + 1 + k);
    }
    mesh.triangles.insert(mesh.triangles.end(), {{4, 5, last}, {7, last + 3, 6}});
    face(4, kFirst, kFirst + 3, 7);
    face(kFirst, kFirst + 1, kFirst + 2, kFirst + 3);
    face(5, 6, last + 3, last);
    face(last, last + 3, last + 2, last + 1);
    return mesh;
}

TriangleMesh blockWithSlotAndBox() {
    constexpr std::uint32_t kCorners = 8;
    constexpr std::array<std::array<double, 2>, kCorners> kBlock = {
        {{-5, -5}, {0.5, -5}, {1, -5}, {5, -5}, {5, 5}, {1, 5}, {0.5, 5}, {-5, 5}}};
    constexpr std::array<std::array<double, 2>, kCorners> kCavity = {
        {{-3, -0.6}, {1, -0.6}, {1, -1.4}, {2.4, -1.4}, {2.4, 1.4}, {1, 1.4}, {1, 0.6}, {-3, 0.6}}};
    TriangleMesh mesh;
    const auto ring = [&](const auto& corners, double z) {
        for (const auto& [x, y] : corners) mesh.vertices.push_back(Vec3(x, y, z).cast<float>());
    };
    ring(kBlock, -5);
    ring(kBlock, 5);
    ring(kCavity, 5);
    ring(kCavity, 3);
    const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    };
    face(7, 6, 1, 0);
    face(6, 5, 2, 1);
    face(5, 4, 3, 2);
    for (std::uint32_t low = 0; low < 3 * kCorners; low += kCorners) {
        for (std::uint32_t i = 0; i < kCorners; ++i) {
            const std::uint32_t next = (i + 1) % kCorners, high = low + kCorners;
            face(low + i, low + next, high + next, high + i);
        }
    }
    constexpr std::uint32_t kFloor = 3 * kCorners;
    face(kFloor, kFloor + 1, kFloor + 6, kFloor + 7);
    face(kFloor + 3, kFloor + 4, kFloor + 5, kFloor + 6);
    face(kFloor + 3, kFloor + 6, kFloor + 1, kFloor + 2);
    return mesh;
}

namespace {

constexpr std::uint32_t kSides = 96;  // of a round cavity, with the corners of the block among them

/// The block with a cavity whose rings, from its opening to its floor, have a height and a radius at each angle each.
template <class RadiusAt>
TriangleMesh turnedBlock(const std::vector<double>& heights, const RadiusAt& radiusAt) {
    TriangleMesh mesh;
    const auto ring = [&](double z, const auto& at) {
        for (std::uint32_t i = 0; i < kSides; ++i) {
            const double angle = 2 * std::numbers::pi * i / kSides, r = at(angle);
            mesh.vertices.push_back(Vec3(r * std::cos(angle), r * std::sin(angle), z).cast<float>());
        }
    };
    const auto block = [](double angle) { return 5 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle))); };
    ring(-5, block);
    ring(5, block);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        ring(heights[i], [&](double angle) { return radiusAt(i, angle); });
    }
    const auto rings = static_cast<std::uint32_t>(heights.size()) + 2;
    const auto bottom = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0, -5);
    mesh.vertices.emplace_back(0, 0, static_cast<float>(heights.back()));
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t next = (i + 1) % kSides;
        mesh.triangles.push_back({bottom, next, i});
        for (std::uint32_t row = 0; row + 1 < rings; ++row) {
            const std::uint32_t low = row * kSides, high = low + kSides;
            mesh.triangles.insert(mesh.triangles.end(),
                                  {{low + i, low + next, high + next}, {low + i, high + next, high + i}});
        }
        const std::uint32_t last = (rings - 1) * kSides;
        mesh.triangles.push_back({bottom + 1, last + i, last + next});
    }
    return mesh;
}

}  // namespace

TriangleMesh blockWithRoundCavity(double radius, double amplitude, int waves, double floor) {
    return turnedBlock({5, floor},
                       [&](std::size_t, double angle) { return radius + amplitude * std::cos(waves * angle); });
}

TriangleMesh blockWithRoundedAngle(double radius, double angle, double floor) {
    constexpr int kSteps = 24;
    std::vector<double> heights = {5}, radii = {radius};
    for (int i = 0; i <= kSteps; ++i) {
        const double turn = std::numbers::pi / 2 * i / kSteps;
        heights.push_back(floor + angle * (1 - std::sin(turn)));
        radii.push_back(radius - angle * (1 - std::cos(turn)));
    }
    return turnedBlock(heights, [&](std::size_t i, double) { return radii[i]; });
}

Preparation blockPreparation(TriangleMesh prepared, TriangleMesh ideal) {
    return {.original = std::make_shared<const SurfacePart>(box(Vec3(-5, -5, -5), Vec3(5, 5, 5))),
            .prepared = std::make_shared<const SurfacePart>(std::move(prepared)),
            .ideal = std::make_shared<const SurfacePart>(std::move(ideal))};
}

double valueOf(const PreparationMeasures& measures, std::string_view id) {
    const Measured measured = findPreparationMetric(id)->measure(measures);
    EXPECT_TRUE(measured.value) << id << ": " << (measured.reason != nullptr ? measured.reason->english : "");
    return measured.value.value_or(-1e9);
}

std::string_view reasonOf(const PreparationMeasures& measures, std::string_view id) {
    const Measured measured = findPreparationMetric(id)->measure(measures);
    EXPECT_FALSE(measured.value) << id;
    return measured.reason != nullptr ? measured.reason->id : "";
}

}  // namespace tactooth::test
