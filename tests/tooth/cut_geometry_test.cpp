// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Compares what is left after a cut with the closed form of the swept region, at voxels of everyday use.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "collision/bvh/closest_point.h"
#include "support/materials.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"
#include "tooth/surface/incremental_surface.h"

namespace tactooth {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNoClearance = 0;
constexpr double kVoxel = 0.025;
constexpr double kRadius = 0.5;

Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }
RevolutionEnvelope flatBur() { return *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), kRadius, 4, 256)); }
RevolutionEnvelope ballBur() { return *RevolutionEnvelope::make(test::sphere(Vec3(0, 0, kRadius), kRadius, 256, 192)); }

/// A block with its top at z = 0. It is cut without clearance.
struct Block {
    explicit Block(double voxel = kVoxel)
        : volume(std::make_shared<const LayeredTooth>(
                     std::move(*LayeredTooth::make(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0))))),
                 voxel),
          surface(volume) {}
    double cut(const RevolutionEnvelope& bur, const Pose& from, const Pose& to) {
        const double removed = carve(bur, from, to);
        show();
        return removed;
    }
    /// Carves only. `show` updates the surface to all carves so far.
    double carve(const RevolutionEnvelope& bur, const Pose& from, const Pose& to) {
        return total(volume.carve(bur, from, to, kNoClearance).removed);
    }
    void show() {
        std::vector<ChangedBrick> changed;
        for (const BrickKey& key : volume.cutBricks()) changed.push_back(ChangedBrick::all(key));
        surface.update(volume, changed);
    }
    [[nodiscard]] TriangleMesh mesh() const { return visibleMesh(*surface.snapshot()).mesh; }
    [[nodiscard]] double lost() const { return 48 - test::volumeOf(mesh()); }

    CutVolume volume;
    IncrementalSurface surface;
};

/// Distances of the wall's vertices and triangle centres below the block's top from their exact places, mm.
struct Deviation {
    double rms = 0;
    double largest = 0;
    int count = 0;
};
Deviation deviationOf(const Surface& surface, const std::function<double(const Vec3&)>& distance,
                      const std::function<bool(const Vec3&)>& counts) {
    Deviation deviation;
    const auto measure = [&](const Vec3& point) {
        if (point.z() > -0.01 || !counts(point)) return;
        const double off = std::abs(distance(point));
        deviation.rms += off * off;
        deviation.largest = std::max(deviation.largest, off);
        ++deviation.count;
    };
    for (const auto& patch : surface.patches) {
        const TriangleMesh& mesh = patch->mesh();
        for (const Vec3f& vertex : mesh.vertices) measure(vertex.cast<double>());
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            measure((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3);
        }
    }
    deviation.rms = std::sqrt(deviation.rms / std::max(1, deviation.count));
    return deviation;
}
bool everywhere(const Vec3&) { return true; }

void expectTrue(const Deviation& deviation) {
    EXPECT_GT(deviation.count, 500);
    EXPECT_LT(deviation.rms, 0.005);
    EXPECT_LT(deviation.largest, 0.012);
}

TEST(CutGeometry, AStraightHoleHasTheBursDiameterAndDepth) {
    Block block;
    block.cut(flatBur(), at(0.013, 0.02, 0.3), at(0.013, 0.02, -1.2));
    double least = 1;
    double most = 0;
    double deepest = 0;
    for (const auto& patch : block.surface.snapshot()->patches) {
        for (const Vec3f& vertex : patch->mesh().vertices) {
            const double radius = std::hypot(vertex.x() - 0.013, vertex.y() - 0.02);
            deepest = std::min(deepest, static_cast<double>(vertex.z()));
            if (vertex.z() > -0.05F || vertex.z() < -1.15F) continue;
            least = std::min(least, radius);
            most = std::max(most, radius);
        }
    }
    EXPECT_NEAR(2 * least, 2 * kRadius, 0.005);
    EXPECT_NEAR(2 * most, 2 * kRadius, 0.005);
    EXPECT_NEAR(deepest, -1.2, 0.005);
}

TEST(CutGeometry, ASlotHasFlatWallsAndASharpInnerEdge) {
    Block block;
    const double removed = block.cut(flatBur(), at(-0.6, 0.01, -0.7), at(0.7, 0.01, -0.7));
    const auto isEdge = [](const Vec3& p) { return p.z() < -0.7 + 1.5 * kVoxel; };
    const auto across = [](const Vec3& p) {  // distance to a stadium in the plane
        const double x = p.x() < -0.6 ? p.x() + 0.6 : p.x() > 0.7 ? p.x() - 0.7 : 0;
        return std::hypot(x, p.y() - 0.01) - kRadius;
    };
    expectTrue(deviationOf(*block.surface.snapshot(), across, [&](const Vec3& p) { return !isEdge(p); }));
    const auto onFloor = [&](const Vec3& p) { return across(p) < -1.5 * kVoxel; };
    expectTrue(deviationOf(
        *block.surface.snapshot(), [](const Vec3& p) { return p.z() + 0.7; }, onFloor));
    const auto fromEdge = [&](const Vec3& p) { return std::max(across(p), -0.7 - p.z()); };
    EXPECT_LT(deviationOf(*block.surface.snapshot(), fromEdge, isEdge).largest, kVoxel);
    const double slot = 0.7 * (kPi * kRadius * kRadius + 1.3 * 2 * kRadius);
    EXPECT_NEAR(removed, slot, 0.003 * slot);
    EXPECT_NEAR(block.lost(), removed, 0.003 * removed);
}

TEST(CutGeometry, ABowlIsASphere) {
    Block block;
    const double removed = block.cut(ballBur(), at(0.01, 0, 0.5), at(0.01, 0, -0.35));
    const auto sphere = [](const Vec3& p) {
        return p.z() < 0.15 ? (p - Vec3(0.01, 0, 0.15)).norm() - kRadius : std::hypot(p.x() - 0.01, p.y()) - kRadius;
    };
    expectTrue(deviationOf(*block.surface.snapshot(), sphere, everywhere));
    const double cap = kPi * 0.35 * 0.35 * (kRadius - 0.35 / 3);
    EXPECT_NEAR(removed, cap, 0.003 * cap);
    EXPECT_NEAR(block.lost(), removed, 0.003 * removed);
}

/// The mean distance of the walls of eight cavities beyond their exact places, mm. Each has a volume of `exact` and an
/// area of `area`.
double meanBeyond(const RevolutionEnvelope& bur, const std::function<Pose(std::mt19937&)>& place, double exact,
                  double area) {
    std::mt19937 random(1);
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        Block block(0.05);
        const Pose pose = place(random);
        block.cut(bur, pose, pose);
        sum += (block.lost() - exact) / area;
    }
    return sum / 8;
}

TEST(CutGeometry, BentWallsEncloseTheVolumeThatWasCut) {
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const double r : {0.25, 0.4}) {
        const auto anywhere = [&](std::mt19937& random) {
            return Pose{0.1 * Vec3(unit(random), unit(random), unit(random)) - 1.5 * Vec3::UnitZ(), Quat::Identity()};
        };
        const auto ball = *RevolutionEnvelope::make(test::sphere(Vec3::Zero(), r, 512, 256));
        EXPECT_NEAR(meanBeyond(ball, anywhere, 4.0 / 3 * kPi * r * r * r, 4 * kPi * r * r), 0, 0.25e-3) << r;
        const auto upright = [&](std::mt19937& random) {
            Pose pose = anywhere(random);
            pose.position.z() = -4;
            return pose;
        };
        const auto rod = *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), r, 6, 512));
        EXPECT_NEAR(meanBeyond(rod, upright, 3 * kPi * r * r, 6 * kPi * r), 0, 0.1e-3) << r;
    }
}

TEST(CutGeometry, ATiltedHoleIsATiltedCylinder) {
    Block block;
    const Quat lean(Eigen::AngleAxisd(0.35, Vec3(1, 0.4, 0).normalized()));
    const Vec3 axis = lean * Vec3::UnitZ();
    const Pose end{-0.9 * axis, lean};
    block.cut(flatBur(), {0.6 * axis, lean}, end);
    const auto cylinder = [&](const Vec3& p) {
        const Vec3 inTool = end.inverse() * p;
        return std::hypot(inTool.x(), inTool.y()) - kRadius;
    };
    const auto onWall = [&](const Vec3& p) { return (end.inverse() * p).z() > 1.5 * kVoxel; };
    expectTrue(deviationOf(*block.surface.snapshot(), cylinder, onWall));
}

TEST(CutGeometry, ABallThatTurnsAboutAFarPointMillsATorus) {
    Block block;
    const Vec3 pivot(0, 0, 4.2);  // on the shaft; the centre of the ball swings about it, 4.4 mm below
    const double arm = 4.4;
    const auto pose = [&](double angle) {
        const Quat turn(Eigen::AngleAxisd(angle, Vec3::UnitX()));
        return Pose{pivot + turn * Vec3(0, 0, -arm - kRadius), turn};
    };
    const auto bur = ballBur();
    for (int i = 0; i < 40; ++i) block.carve(bur, pose(-0.1 + 0.005 * i), pose(-0.1 + 0.005 * (i + 1)));
    block.show();
    const auto torus = [&](const Vec3& p) {
        const Vec3 inPlane(0, p.y(), p.z() - pivot.z());
        const double angle = std::clamp(std::atan2(p.y(), pivot.z() - p.z()), -0.1, 0.1);
        const Vec3 nearest = pivot + arm * Vec3(0, std::sin(angle), -std::cos(angle));
        return (p - nearest).norm() - kRadius;
    };
    expectTrue(deviationOf(*block.surface.snapshot(), torus, everywhere));
}

TEST(CutGeometry, HalfTheVoxelIsAtMostHalfTheError) {
    std::vector<Deviation> byVoxel;
    for (const double voxel : {0.1, 0.05, 0.025}) {
        Block block(voxel);
        block.cut(ballBur(), at(0.01, 0.02, 0.5), at(0.01, 0.02, -0.4));
        const auto sphere = [](const Vec3& p) { return (p - Vec3(0.01, 0.02, 0.1)).norm() - kRadius; };
        byVoxel.push_back(deviationOf(*block.surface.snapshot(), sphere, everywhere));
    }
    for (std::size_t i = 1; i < byVoxel.size(); ++i) EXPECT_LT(byVoxel[i].rms, 0.5 * byVoxel[i - 1].rms) << i;
}

/// A plunge, a stroke with a rotation, and a retreat: a fast motion of 0.1 s.
Pose devicePoseAt(double time) {
    const double t = time / 0.1;
    const Quat lean(Eigen::AngleAxisd(0.25 * std::sin(3 * t), Vec3(0.6, 0.8, 0)));
    return {Vec3(-0.6 + 1.2 * t, 0.3 * std::sin(5 * t), 0.4 - 1.1 * std::sin(kPi * t)), lean};
}

TEST(CutGeometry, OneAndFourKilohertzCutTheSame) {
    std::vector<double> removed;
    std::vector<TriangleMesh> meshes;
    for (const double rate : {1000.0, 4000.0}) {
        Block block;
        const auto bur = flatBur();
        double sum = 0;
        const int ticks = static_cast<int>(std::lround(0.1 * rate));
        for (int i = 0; i < ticks; ++i) sum += block.carve(bur, devicePoseAt(i / rate), devicePoseAt((i + 1) / rate));
        block.show();
        removed.push_back(sum);
        meshes.push_back(block.mesh());
        EXPECT_NEAR(block.lost(), sum, 0.003 * sum) << "what each tick removed adds up to what is gone";
    }
    EXPECT_NEAR(removed[0], removed[1], 0.005 * removed[1]);
    const SurfacePart fine(meshes[1]);
    double square = 0;
    for (const Vec3f& vertex : meshes[0].vertices) {
        const auto hit = closestPoint(fine, vertex.cast<double>(), 0.2);
        ASSERT_TRUE(hit);
        square += hit->distance * hit->distance;
    }
    EXPECT_LT(std::sqrt(square / static_cast<double>(meshes[0].vertices.size())), 0.005);
}

TEST(CutGeometry, EachMaterialLosesWhatIsMissingOfItsLayer) {
    const TriangleMesh outer = test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0));
    std::vector<LayerMesh> layers;
    layers.push_back({"enamel", test::kEnamel, outer});
    layers.push_back({"dentin", test::kDentin, test::box(Vec3(-1.9, -1.9, -2.9), Vec3(1.9, 1.9, -0.43))});
    CutVolume volume(std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(outer, layers))), kVoxel);
    MaterialVolumes removed{};
    for (int i = 0; i < 12; ++i) {
        const CarveResult step =
            volume.carve(flatBur(), at(0.011, 0, 0.2 - 0.1 * i), at(0.011, 0, 0.1 - 0.1 * i), kNoClearance);
        for (std::size_t m = 0; m < kMaxMaterials; ++m) removed[m] += step.removed[m];
    }
    const double area = kPi * kRadius * kRadius;
    EXPECT_NEAR(removed[static_cast<std::size_t>(test::kEnamel)], 0.43 * area, 0.01 * 0.43 * area);
    EXPECT_NEAR(removed[static_cast<std::size_t>(test::kDentin)], 0.57 * area, 0.01 * 0.57 * area);
}

}  // namespace
}  // namespace tactooth
