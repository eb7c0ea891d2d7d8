// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The crowns of the average mouth against measured ones. Teeth of the left side are mirror images of these
// (PermanentTooth.HasItsMirrorImageOnTheOtherSide).
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

#include "geometry/io/stl_reader.h"
#include "instruments/crown_measures.h"
#include "support/sanitizer.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

constexpr int kTriangles = 12000;

/// What the tooth must not exceed; mm but for the correlation. A change of its form lowers these numbers.
struct Limit {
    int fdi;
    double mirrorCorrelation, section, outline, tips, table, edge, thickness;
};

constexpr std::array<Limit, 16> kLimits = {{{11, 0.86, 0.20, 0.08, 0, 0, 0.15, 0.08},
                                            {12, 0.76, 0.35, 0.08, 0, 0, 0.22, 0.08},
                                            {13, 0.75, 0.20, 0.08, 0, 0, 0.30, 0.15},
                                            {14, 0.85, 0.40, 0.08, 0.30, 0, 0, 0},
                                            {15, 0.84, 0.40, 0.08, 0.30, 0, 0, 0},
                                            {16, 0.70, 0.40, 0.08, 0.30, 0.30, 0, 0},
                                            {17, 0.27, 0.40, 0.08, 0.30, 0, 0, 0},
                                            {18, 0.66, 0, 0, 0, 0, 0, 0},
                                            {41, 0.85, 0.35, 0.08, 0, 0, 0.15, 0.08},
                                            {42, 0.82, 0.25, 0.08, 0, 0, 0.22, 0.08},
                                            {43, 0.78, 0.20, 0.08, 0, 0, 0.20, 0.10},
                                            {44, 0.90, 0.40, 0.08, 0.30, 0, 0, 0},
                                            {45, 0.76, 0.40, 0.08, 0.30, 0, 0, 0},
                                            {46, 0.84, 0.40, 0.08, 0.30, 0.30, 0, 0},
                                            {47, 0.88, 0.40, 0.08, 0.30, 0.30, 0, 0},
                                            {48, 0.72, 0, 0, 0, 0, 0, 0}}};
constexpr double kMeanCorrelation = 0.76;  // that of real teeth is 0.79

TEST(CrownAnatomy, IsNotFartherFromMeasuredTeethThanItsLimits) {
    std::printf("%-6s %10s %10s %10s %10s %10s %10s %10s\n", "teeth", "mirror", "section", "outline", "tips", "table",
                "edge", "thickness");
    const auto teeth = test::cases<std::size_t>(kLimits.size(), 2);
    double sum = 0;
    for (std::size_t i = 0; i < teeth; ++i) {
        const Limit& limit = kLimits[i];
        const test::CrownDeviation is = test::deviationOf(makeTooth({limit.fdi, kTriangles, 0, {}}));
        const double edge = is.edge.value_or(0), thickness = is.thickness.value_or(0);
        std::printf("%d %d  %10.3f %10.2f %10.3f %10.2f %10.2f %10.2f %10.2f\n", limit.fdi,
                    limit.fdi + (limit.fdi < 20 ? 10 : -10), is.mirrorCorrelation, is.section, is.outline,
                    is.tips.value_or(0), is.table.value_or(0), edge, thickness);
        sum += is.mirrorCorrelation;
        EXPECT_LE(is.mirrorCorrelation, limit.mirrorCorrelation) << limit.fdi;
        EXPECT_LE(is.section, limit.section) << limit.fdi;
        EXPECT_LE(is.outline, limit.outline) << limit.fdi;
        EXPECT_LE(is.tips.value_or(0), limit.tips) << limit.fdi;
        EXPECT_LE(is.table.value_or(0), limit.table) << limit.fdi;
        EXPECT_LE(edge, limit.edge) << limit.fdi;
        EXPECT_LE(thickness, limit.thickness) << limit.fdi;
    }
    std::printf("mean   %10.3f\n", sum / static_cast<double>(teeth));
    if (teeth == kLimits.size()) {
        EXPECT_LE(sum / static_cast<double>(teeth), kMeanCorrelation);
    }
}

/// A real tooth: a lower one of an adult, or an extracted upper molar.
struct RealTooth {
    int fdi;
    const char* file;
    bool mirrored;    ///< it is a tooth of the other side
    bool lies;        ///< its crown is at +x, not at +z
    double distance;  ///< limit, mm
};

constexpr RealTooth kRealTeeth[] = {{16, "microct-meshes/tooth_2_outer.stl", false, true, 0.19},
                                    {32, "openmandible/whole/L1_whole.stl", true, false, 0.14},
                                    {33, "openmandible/whole/L3_whole.stl", false, false, 0.18},
                                    {36, "openmandible/whole/L6_whole.stl", false, false, 0.21}};

TEST(CrownAnatomy, IsAsNearToARealToothAsItsLimit) {
    const auto folder = test::realTeethFolder();
    if (!folder) GTEST_SKIP() << "needs real teeth; the measured tables are tested above";
    for (const RealTooth& tooth : kRealTeeth) {
        TriangleMesh real = *readStl(*folder / tooth.file);
        if (tooth.mirrored) {
            for (Vec3f& vertex : real.vertices) vertex.x() = -vertex.x();
            for (Triangle& triangle : real.triangles) std::swap(triangle[1], triangle[2]);
        }
        if (tooth.lies) {
            for (Vec3f& vertex : real.vertices) vertex = Vec3f(vertex.y(), vertex.z(), vertex.x());
        }
        constexpr double kFrom = 1.5;  // mm: the crown above its neck
        const TriangleMesh model = makeTooth({tooth.fdi, kTriangles, 0, {}}).outer;
        const double distance = test::distanceFromReal(model, real, kFrom);
        std::printf("%d  %.3f mm from a real one\n", tooth.fdi, distance);
        EXPECT_LE(distance, tooth.distance) << tooth.fdi;
    }
}

}  // namespace
}  // namespace tactooth
