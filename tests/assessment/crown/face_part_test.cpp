// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/face_part.h"

#include <gtest/gtest.h>

#include <vector>

namespace tactooth {
namespace {

double areaOf(const TriangleMesh& mesh) {
    double area = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) area += mesh.areaVector(i).norm() / 2;
    return area;
}

/// A unit square of two triangles.
const TriangleMesh kSquare{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};

TEST(FacePart, EndsInAStraightLineAcrossTheTriangles) {
    const TriangleMesh part = partAbove(kSquare, std::vector<double>{-0.3, -0.3, 0.7, 0.7});  // y - 0.3
    EXPECT_NEAR(areaOf(part), 0.7, 1e-6);
    for (const Triangle& triangle : part.triangles) {
        for (const std::uint32_t vertex : triangle) EXPECT_GE(part.vertices[vertex].y(), 0.3F - 1e-6F);
    }
    for (std::size_t i = 0; i < part.triangles.size(); ++i) EXPECT_GT(part.areaVector(i).z(), 0) << i;
}

TEST(FacePart, IsAllOrNothingWhereTheValueHasOneSign) {
    EXPECT_EQ(partAbove(kSquare, std::vector<double>{1, 1, 2, 1}).triangles, kSquare.triangles);
    EXPECT_TRUE(partAbove(kSquare, std::vector<double>{-1, 0, -2, 0}).empty());
}

TEST(FacePart, AndTheRestMakeTheWhole) {
    const std::vector<double> values = {0.2, -0.5, 0.4, -0.1};
    std::vector<double> opposite;
    for (const double value : values) opposite.push_back(-value);
    EXPECT_NEAR(areaOf(partAbove(kSquare, values)) + areaOf(partAbove(kSquare, opposite)), 1, 1e-6);
}

}  // namespace
}  // namespace tactooth
