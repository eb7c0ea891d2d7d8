// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The crowns of the average mouth against measured ones. Teeth of the left side are mirror images of these
// (PermanentTooth.HasItsMirrorImageOnTheOtherSide).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "collision/bvh/closest_point.h"
#include "geometry/io/stl_reader.h"
#include "instruments/crown_measures.h"
#include "instruments/face_measures.h"
#include "instruments/real_crowns.h"
#include "support/sanitizer.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

constexpr int kTriangles = 12000;

/// What is measured of a tooth: mm but for the correlation; 0 where nothing is measured.
struct Deviations {
    double mirrorCorrelation, section, outline, tips, table, edge, thickness, contour, fossa, enamel;
};

/// What the tooth must not exceed. A change of its form lowers these numbers.
struct Limit {
    int fdi;
    Deviations most;
};

constexpr std::array<Limit, 16> kLimits = {{{11, {0.86, 0.20, 0.08, 0, 0, 0.15, 0.08, 0.3, 0.07, 0}},
                                            {12, {0.76, 0.35, 0.08, 0, 0, 0.20, 0.08, 0.3, 0.08, 0}},
                                            {13, {0.75, 0.20, 0.08, 0, 0, 0.30, 0.15, 0.3, 0.08, 0}},
                                            {14, {0.85, 0.40, 0.08, 0.30, 0, 0, 0, 0.3, 0, 0}},
                                            {15, {0.84, 0.40, 0.08, 0.30, 0, 0, 0, 0.3, 0, 0}},
                                            {16, {0.70, 0.40, 0.08, 0.30, 0.30, 0, 0, 0.3, 0, 0.25}},
                                            {17, {0.27, 0.40, 0.08, 0.30, 0, 0, 0, 0.45, 0, 0}},
                                            {18, {0.66, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
                                            {41, {0.85, 0.35, 0.08, 0, 0, 0.15, 0.08, 0.3, 0.05, 0}},
                                            {42, {0.82, 0.25, 0.08, 0, 0, 0.20, 0.08, 0.3, 0.05, 0.15}},
                                            {43, {0.78, 0.20, 0.08, 0, 0, 0.20, 0.10, 0.3, 0.08, 0.15}},
                                            {44, {0.90, 0.40, 0.08, 0.30, 0, 0, 0, 0.3, 0, 0.25}},
                                            {45, {0.76, 0.40, 0.08, 0.30, 0, 0, 0, 0.3, 0, 0.2}},
                                            {46, {0.84, 0.40, 0.08, 0.30, 0.30, 0, 0, 0.3, 0, 0.2}},
                                            {47, {0.88, 0.40, 0.08, 0.30, 0.30, 0, 0, 0.3, 0, 0.25}},
                                            {48, {0.72, 0, 0, 0, 0, 0, 0, 0, 0, 0}}}};
constexpr double kMeanCorrelation = 0.76;  // that of real teeth is 0.79

struct Measure {
    const char* name;
    double Deviations::*value;
};
constexpr std::array<Measure, 10> kMeasures = {{{"mirror", &Deviations::mirrorCorrelation},
                                                {"section", &Deviations::section},
                                                {"outline", &Deviations::outline},
                                                {"tips", &Deviations::tips},
                                                {"table", &Deviations::table},
                                                {"edge", &Deviations::edge},
                                                {"thickness", &Deviations::thickness},
                                                {"contour", &Deviations::contour},
                                                {"fossa", &Deviations::fossa},
                                                {"enamel", &Deviations::enamel}}};

Deviations deviationsOf(const BuiltinTooth& tooth) {
    const test::CrownDeviation crown = test::deviationOf(tooth);
    return {crown.mirrorCorrelation,
            crown.section,
            crown.outline,
            crown.tips.value_or(0),
            crown.table.value_or(0),
            crown.edge.value_or(0),
            crown.thickness.value_or(0),
            test::contourDeviation(tooth).value_or(0),
            test::fossaDeviation(tooth).value_or(0),
            test::enamelDeviation(tooth).value_or(0)};
}

TEST(CrownAnatomy, IsNotFartherFromMeasuredTeethThanItsLimits) {
    std::printf("teeth");
    for (const Measure& measure : kMeasures) std::printf(" %9s", measure.name);
    std::printf("   depths of contour: mesial distal buccal lingual\n");
    const auto teeth = test::cases<std::size_t>(kLimits.size(), 2);
    double sum = 0;
    for (std::size_t i = 0; i < teeth; ++i) {
        const auto& [fdi, most] = kLimits[i];
        const BuiltinTooth tooth = makeTooth({fdi, kTriangles, 0, {}});
        const Deviations is = deviationsOf(tooth);
        std::printf("%d %d", fdi, fdi + (fdi < 20 ? 10 : -10));
        for (const Measure& measure : kMeasures) {
            std::printf(" %9.3f", is.*measure.value);
            EXPECT_LE(is.*measure.value, most.*measure.value) << fdi << " " << measure.name;
        }
        const test::Contours at = test::contoursOf(tooth);
        std::printf("   %.1f %.1f %.1f %.1f\n", at.mesial, at.distal, at.buccal, at.lingual);
        sum += is.mirrorCorrelation;
    }
    std::printf("mean  %9.3f\n", sum / static_cast<double>(teeth));
    if (teeth == kLimits.size()) {
        EXPECT_LE(sum / static_cast<double>(teeth), kMeanCorrelation);
    }
}

/// A real tooth: a lower one of an adult, or an extracted upper molar.
struct RealTooth {
    int fdi;
    const char* file;
    const char* dentin;       ///< of a file with the enamel alone, whose inner side does not count
    bool mirrored;            ///< it is a tooth of the other side
    bool lies;                ///< its crown is at +x, not at +z
    test::RealDistance most;  ///< limits
};

constexpr RealTooth kRealTeeth[] = {
    {16, "microct-meshes/tooth_2_outer.stl", nullptr, false, true, {0.19, 0.25}},
    {32, "openmandible/whole/L1_whole.stl", nullptr, true, false, {0.14, 0.17}},
    {33, "openmandible/whole/L3_whole.stl", nullptr, false, false, {0.18, 0.25}},
    {34, "openmandible/layered/L4_enamel.stl", "openmandible/layered/L4_dentin.stl", false, false, {0.19, 0.32}},
    {35, "openmandible/layered/L5_enamel.stl", "openmandible/layered/L5_dentin.stl", false, false, {0.16, 0.22}},
    {36, "openmandible/whole/L6_whole.stl", nullptr, false, false, {0.20, 0.45}},  // its buccal cusps are worn
    {37, "openmandible/layered/L7_enamel.stl", "openmandible/layered/L7_dentin.stl", false, false, {0.17, 0.14}}};

// Between two of three extracted upper first molars, in the same way: 0.19 to 0.28 mm, relief 0.31 to 0.70 mm; mean.
constexpr test::RealDistance kBetweenPeople = {0.224, 0.459};

/// The outer side of an enamel cap.
TriangleMesh withoutInnerSide(TriangleMesh enamel, const TriangleMesh& dentin) {
    constexpr double kSame = 0.03;  // mm: the two layers meet there
    const SurfacePart inner(dentin);
    std::vector<Triangle> outer;
    for (std::size_t i = 0; i < enamel.triangles.size(); ++i) {
        const Vec3 centre = (enamel.corner(i, 0) + enamel.corner(i, 1) + enamel.corner(i, 2)) / 3;
        if (!closestPoint(inner, centre, kSame)) outer.push_back(enamel.triangles[i]);
    }
    enamel.triangles = std::move(outer);
    return enamel;
}

TriangleMesh read(const RealTooth& tooth, const std::filesystem::path& folder) {
    TriangleMesh real = *readStl(folder / tooth.file);
    if (tooth.dentin != nullptr) real = withoutInnerSide(std::move(real), *readStl(folder / tooth.dentin));
    if (tooth.mirrored) {
        for (Vec3f& vertex : real.vertices) vertex.x() = -vertex.x();
        for (Triangle& triangle : real.triangles) std::swap(triangle[1], triangle[2]);
    }
    if (tooth.lies) {
        for (Vec3f& vertex : real.vertices) vertex = Vec3f(vertex.y(), vertex.z(), vertex.x());
    }
    return real;
}

TEST(CrownAnatomy, IsAsNearToARealToothAsItsLimit) {
    const auto folder = test::realTeethFolder();
    if (!folder) GTEST_SKIP() << "needs real teeth; the measured tables are tested above";
    for (const RealTooth& tooth : kRealTeeth) {
        constexpr double kFrom = 1.5;  // mm: the crown above its neck
        const TriangleMesh model = makeTooth({tooth.fdi, kTriangles, 0, {}}).outer;
        const auto face = isAnteriorTooth(tooth.fdi) ? test::CrownFace::Lingual : test::CrownFace::Occlusal;
        const test::RealDistance is = test::distanceFromReal(model, read(tooth, *folder), face, kFrom);
        std::printf("%d  %.3f mm from a real one, relief %.3f mm\n", tooth.fdi, is.crown, is.relief);
        EXPECT_LE(is.crown, std::min(tooth.most.crown, 1.2 * kBetweenPeople.crown)) << tooth.fdi;
        EXPECT_LE(is.relief, std::min(tooth.most.relief, 1.25 * kBetweenPeople.relief)) << tooth.fdi;
    }
}

}  // namespace
}  // namespace tactooth
