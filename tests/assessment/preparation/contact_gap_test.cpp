// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/contact_gap.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "assessment/preparation/prepared_blocks.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using namespace test;

constexpr double kLength = 0.02;                                     // mm: what has to be reached
constexpr double kHalfWidth = 1.5, kFloor = 2, kTop = 5, kSide = 5;  // mm: of the box in the block's mesial side

/// The whole block, from (-5, -5, -5) to (5, 5, 5), without the box from x = `axial` to `end`, 3 mm wide, down to
/// z = 2: made of cells.
TriangleMesh blockWithProximalBox(double axial, double end = kSide) {
    std::vector<double> x = {-5, axial, end};
    if (end < kSide) x.push_back(kSide);
    const std::vector<double> y = {-5, -kHalfWidth, kHalfWidth, 5}, z = {-5, kFloor, kTop};
    const std::array<int, 3> counts = {static_cast<int>(x.size()) - 1, 3, 2};
    const auto isSolid = [&](const std::array<int, 3>& cell) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (cell[k] < 0 || cell[k] >= counts[k]) return false;
        }
        return cell != std::array{1, 1, 1};
    };
    TriangleMesh mesh;
    const auto vertexAt = [&](const std::array<int, 3>& at) {
        return static_cast<std::uint32_t>((at[2] * 4 + at[1]) * static_cast<int>(x.size()) + at[0]);
    };
    for (const double pz : z) {
        for (const double py : y) {
            for (const double px : x) mesh.vertices.push_back(Vec3(px, py, pz).cast<float>());
        }
    }
    for (int i = 0; i < counts[0]; ++i) {
        for (int j = 0; j < counts[1]; ++j) {
            for (int k = 0; k < counts[2]; ++k) {
                const std::array cell = {i, j, k};
                if (!isSolid(cell)) continue;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    for (const int sense : {-1, 1}) {
                        std::array beside = cell;
                        beside[axis] += sense;
                        if (isSolid(beside)) continue;
                        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
                        std::array corner = cell;
                        if (sense > 0) ++corner[axis];
                        std::array<std::array<int, 3>, 4> face = {corner, corner, corner, corner};
                        ++face[sense > 0 ? 1 : 3][u];
                        ++face[2][u];
                        ++face[2][v];
                        ++face[sense > 0 ? 3 : 1][v];
                        const std::array<std::uint32_t, 4> at = {vertexAt(face[0]), vertexAt(face[1]),
                                                                 vertexAt(face[2]), vertexAt(face[3])};
                        mesh.triangles.insert(mesh.triangles.end(), {{at[0], at[1], at[2]}, {at[0], at[2], at[3]}});
                    }
                }
            }
        }
    }
    return mesh;
}

ContactGap gapWith(TriangleMesh neighbour, const TriangleMesh& work = blockWithProximalBox(3)) {
    Preparation preparation = blockPreparation(work, blockWithProximalBox(3));
    if (!neighbour.empty()) preparation.neighbours = std::make_shared<const SurfacePart>(std::move(neighbour));
    return contactGap(preparation, CutSurfaces(preparation));
}

double of(const Measured& measured) {
    EXPECT_TRUE(measured.value) << (measured.reason != nullptr ? measured.reason->english : "");
    return measured.value.value_or(-1e9);
}

/// Along y, `radius` thick: nearest to the block at the height of its axis.
TriangleMesh lyingCylinder(double gap, double radius, double height) {
    const Pose lying{Vec3(kSide + gap + radius, -8, height),
                     Quat(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitX()))};
    return transformed(cylinder(Vec3::Zero(), radius, 16, 360), lying);
}

TEST(ContactGap, OfFlatSidesIsTheSameAtAllMargins) {
    for (const double gap : {0.05, 0.3, 0.5, 1.2}) {
        const ContactGap flat = gapWith(box(Vec3(kSide + gap, -5, -5), Vec3(12, 5, 5)));
        for (const Measured* each : {&flat.gingival, &flat.buccal, &flat.lingual}) {
            EXPECT_NEAR(of(*each), gap, kLength);
            EXPECT_NEAR(each->place->x(), kSide, 1e-3);
        }
        EXPECT_NEAR(flat.gingival.place->z(), kFloor, 0.1);
        EXPECT_GT(flat.buccal.place->y(), 1);
        EXPECT_LT(flat.lingual.place->y(), -1);
    }
}

/// A round neighbour touches the block in the middle of the box: an upright cylinder.
TEST(ContactGap, OfARoundNeighbourIsWiderAtItsSides) {
    constexpr double kRadius = 4, kGap = 0.1, kAside = 0.4;
    const ContactGap round = gapWith(cylinder(Vec3(kSide + kGap + kRadius, kAside, -5), kRadius, 10, 720));
    EXPECT_NEAR(of(round.gingival), kGap, kLength);
    EXPECT_NEAR(of(round.buccal), std::hypot(kGap + kRadius, kHalfWidth - kAside) - kRadius, kLength);
    EXPECT_NEAR(of(round.lingual), std::hypot(kGap + kRadius, kHalfWidth + kAside) - kRadius, kLength);
}

/// A contact above the floor of the box: a cylinder that lies across it.
TEST(ContactGap, OfAContactAboveTheFloorIsWiderAtTheGingivalMargin) {
    constexpr double kRadius = 3, kGap = 0.2, kHeight = 4;
    const ContactGap above = gapWith(lyingCylinder(kGap, kRadius, kHeight));
    EXPECT_NEAR(of(above.gingival), std::hypot(kGap + kRadius, kHeight - kFloor) - kRadius, kLength);
    EXPECT_NEAR(of(above.buccal), kGap, kLength);
    EXPECT_NEAR(of(above.lingual), kGap, kLength);
}

TEST(ContactGap, IsNoneBeforeTheBoxReachesTheOutside) {
    const ContactGap closed = gapWith(box(Vec3(5.3, -5, -5), Vec3(12, 5, 5)), blockWithProximalBox(3, 4.7));
    for (const Measured* each : {&closed.gingival, &closed.buccal, &closed.lingual}) EXPECT_EQ(of(*each), 0);
}

TEST(ContactGap, HasAReasonWhereThereIsNothingToMeasure) {
    const auto reason = [](const ContactGap& gap) { return gap.gingival.reason->id; };
    EXPECT_EQ(reason(gapWith({})), "no_neighbour_known");
    EXPECT_EQ(reason(gapWith(box(Vec3(-12, -5, -5), Vec3(-5.2, 5, 5)))), "no_neighbour_there");
    Preparation classOne = blockPreparation(blockWithBox(-2, 2, -1.5, 1.5, 3), blockWithBox(-2, 2, -1.5, 1.5, 3));
    classOne.neighbours = std::make_shared<const SurfacePart>(box(Vec3(5.2, -5, -5), Vec3(12, 5, 5)));
    EXPECT_EQ(reason(contactGap(classOne, CutSurfaces(classOne))), "no_box");
    classOne.axis = Vec3::UnitY();
    EXPECT_EQ(reason(contactGap(classOne, CutSurfaces(classOne))), "not_occlusal");
}

}  // namespace
}  // namespace tactooth
