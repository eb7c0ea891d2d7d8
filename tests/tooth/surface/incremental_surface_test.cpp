// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/incremental_surface.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "collision/bvh/closest_point.h"
#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"
#include "support/materials.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;
constexpr double kPi = std::numbers::pi;

RevolutionEnvelope envelopeOf(const TriangleMesh& bur) { return *RevolutionEnvelope::make(bur); }
RevolutionEnvelope flatBur(double radius) { return envelopeOf(test::cylinder(Vec3::Zero(), radius, 4, 128)); }
RevolutionEnvelope ballBur(double radius) { return envelopeOf(test::sphere(Vec3(0, 0, radius), radius, 128, 96)); }
Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }

/// A tooth with its cut volume and surface.
struct CutTooth {
    explicit CutTooth(TriangleMesh outer, double voxel = kVoxel)
        : volume(std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(std::move(outer)))), voxel),
          surface(volume) {}

    double cut(const RevolutionEnvelope& bur, const Pose& from, const Pose& to, double clearance = 0) {
        const CarveResult result = volume.carve(bur, from, to, clearance);
        surface.update(volume, result.changed);
        return total(result.removed);
    }
    [[nodiscard]] TriangleMesh mesh() const { return visibleMesh(*surface.snapshot()).mesh; }

    CutVolume volume;
    IncrementalSurface surface;
};

/// Counts directed edges, by the bits of their ends, that do not have exactly one partner in the other direction.
int badEdges(const TriangleMesh& mesh) {
    using Point = std::array<float, 3>;
    std::map<std::pair<Point, Point>, int> count;
    for (const Triangle& triangle : mesh.triangles) {
        const auto point = [&](int i) {
            const Vec3f& v = mesh.vertices[triangle[i % 3]];
            return Point{v.x(), v.y(), v.z()};
        };
        if (point(0) == point(1) || point(1) == point(2) || point(2) == point(0)) continue;
        for (int i = 0; i < 3; ++i) ++count[{point(i), point(i + 1)}];
    }
    int bad = 0;
    for (const auto& [edge, times] : count) {
        const auto back = count.find({edge.second, edge.first});
        bad += times != 1 || back == count.end();
    }
    return bad;
}

void expectSameTriangles(const TriangleMesh& mesh, const TriangleMesh& expected) {
    ASSERT_EQ(mesh.triangles.size(), expected.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int c = 0; c < 3; ++c) ASSERT_EQ(mesh.corner(t, c), expected.corner(t, c));
    }
}

/// Two blocks with a gap of 0.02 mm. The second one, at greater x, is a body around the first.
constexpr double kBetween = 0.02;
LayeredTooth twoBlocks() {
    TriangleMesh outer = test::box(Vec3(-1, -1, -2), Vec3(1, 1, 0));
    const auto first = static_cast<std::uint32_t>(outer.triangles.size());
    append(outer, test::box(Vec3(1 + kBetween, -1, -2), Vec3(3, 1, 0)));
    return *LayeredTooth::make(std::move(outer), {}, test::kEnamel, {.firstAdjacent = first});
}

double volumeCutFrom(const TriangleMesh& left, double whole) { return whole - test::volumeOf(left); }

// A bur that prepares the contact of two teeth cuts both. Each keeps a closed surface of its own.
TEST(IncrementalSurface, ACutOfABodyAroundTheToothCountsForThatBody) {
    const auto tooth = std::make_shared<const LayeredTooth>(twoBlocks());
    CutVolume volume(tooth, kVoxel / 2);
    IncrementalSurface surface(volume);
    const RevolutionEnvelope bur = ballBur(0.4);
    MaterialVolumes removed{};
    for (const auto& [from, to] : {std::pair(at(1.01, -1.5, -0.3), at(1.01, 1.5, -0.3)),     // through the contact
                                   std::pair(at(2, 0.3, 0.5), at(2, 0.3, -0.8)),             // in the neighbour
                                   std::pair(at(-0.2, -0.1, 0.5), at(-0.2, -0.1, -1.1))}) {  // in the tooth itself
        const CarveResult result = volume.carve(bur, from, to, 0);
        surface.update(volume, result.changed);
        for (std::size_t i = 0; i < kMaxMaterials; ++i) removed[i] += result.removed[i];
    }
    const Surface cut = *surface.snapshot();
    const TriangleMesh own = visibleToothMesh(cut).mesh;
    const TriangleMesh all = visibleMesh(cut).mesh;
    EXPECT_EQ(badEdges(own), 0);
    EXPECT_EQ(badEdges(all), 0);
    EXPECT_EQ(boundingBox(own).max().x(), 1);
    const double beside = test::volumeOf(all) - test::volumeOf(own);
    const double wholeBeside = test::volumeOf(visibleMesh({.base = tooth->outer()}).mesh) - 8;
    EXPECT_GT(volumeCutFrom(own, 8), 0.5);
    EXPECT_GT(wholeBeside - beside, 0.5);
    EXPECT_NEAR(surface.lostAdjacent(), wholeBeside - beside, 1e-5);  // of 0.5; the volumes come from floats
    surface.reset();
    EXPECT_EQ(surface.lostAdjacent(), 0);
    EXPECT_NEAR(volumeCutFrom(all, 8 + wholeBeside), total(removed), 0.003 * total(removed));
    int split = 0;
    for (const auto& patch : cut.patches) {
        for (std::uint32_t t = 0; t < patch->mesh().triangles.size(); ++t) {
            const TriangleMesh& mesh = patch->mesh();
            const double x = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)).x() / 3;
            ASSERT_EQ(patch->isAdjacent(t), x > 1 + kBetween / 2) << x;
        }
        split += patch->isAdjacent(0)
                     ? 0
                     : patch->isAdjacent(static_cast<std::uint32_t>(patch->mesh().triangles.size()) - 1);
    }
    EXPECT_GT(split, 10) << "bricks with walls of both";
}

TriangleMesh fineSphere() { return test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64); }

TEST(IncrementalSurface, AnUncutToothIsItsFile) {
    const CutTooth patient(fineSphere());
    const TriangleMesh mesh = patient.mesh();
    expectSameTriangles(mesh, fineSphere());
}

TEST(IncrementalSurface, AHoleInABlockIsClosedAndHasTheVolumeOfTheBur) {
    CutTooth patient(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0)));
    const double removed = patient.cut(flatBur(0.6), at(0.01, 0.02, 0.5), at(0.01, 0.02, -1.5));
    const TriangleMesh mesh = patient.mesh();
    EXPECT_EQ(badEdges(mesh), 0);
    EXPECT_EQ(patient.surface.failures(), 0U);
    EXPECT_NEAR(48 - test::volumeOf(mesh), kPi * 0.36 * 1.5, 0.003 * kPi * 0.36 * 1.5);
    EXPECT_NEAR(48 - test::volumeOf(mesh), removed, 0.003 * removed);
}

TEST(IncrementalSurface, WallsLieOnTheBurAndInnerEdgesAreSharp) {
    CutTooth patient(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0)));
    const auto bur = flatBur(0.6);
    const Pose tilted{Vec3(0, 0, -1.2), Quat(Eigen::AngleAxisd(0.3, Vec3(1, 0.5, 0).normalized()))};
    patient.cut(bur, tilted, tilted);
    double worstSmooth = 0;
    double worstEdge = 0;
    for (const auto& patch : patient.surface.snapshot()->patches) {
        for (const Vec3f& vertex : patch->mesh().vertices) {
            const Vec3 point = tilted.inverse() * Vec3(vertex.cast<double>());
            if (vertex.z() > -0.001F) continue;
            const double distance = std::abs(bur.signedDistance(point));
            const bool nearEdge = std::hypot(point.x(), point.y()) > 0.6 - 1.5 * kVoxel && point.z() < 1.5 * kVoxel;
            (nearEdge ? worstEdge : worstSmooth) = std::max(nearEdge ? worstEdge : worstSmooth, distance);
        }
    }
    EXPECT_LT(worstSmooth, 0.0015);
    EXPECT_LT(worstEdge, 0.5 * kVoxel);
}

TEST(IncrementalSurface, UntouchedTrianglesKeepTheirBits) {
    CutTooth patient(fineSphere());
    patient.cut(ballBur(0.4), at(0, 0, 0.2), at(0, 0, -0.4));
    const auto snapshot = patient.surface.snapshot();
    const TriangleMesh& base = snapshot->base->mesh();
    std::size_t hidden = 0;
    for (std::uint32_t t = 0; t < base.triangles.size(); ++t) {
        if (!isHidden(*snapshot->hidden, t)) continue;
        ++hidden;
        for (int c = 0; c < 3; ++c) EXPECT_LT(std::hypot(base.corner(t, c).x(), base.corner(t, c).y()), 0.7);
    }
    EXPECT_GT(hidden, 10U);
    const TriangleMesh mesh = visibleMesh(*snapshot).mesh;
    std::size_t next = 0;
    for (std::uint32_t t = 0; t < base.triangles.size(); ++t) {
        if (isHidden(*snapshot->hidden, t)) continue;
        for (int c = 0; c < 3; ++c) ASSERT_EQ(mesh.corner(next, c), base.corner(t, c));
        ++next;
    }
}

/// The triangles of all leaves that a traversal of the base's visible tree reaches.
std::set<std::uint32_t> reached(const Surface& surface) {
    std::set<std::uint32_t> triangles;
    const auto& [tree, hidden] = visibleBase(surface);
    std::vector<AabbTree::Link> open = {tree.rootLink()};
    while (!open.empty()) {
        const AabbTree::Link link = open.back();
        open.pop_back();
        if (link.isLeaf()) {
            const AabbTree::Leaf& leaf = tree.leaf(link);
            triangles.insert(leaf.triangle, leaf.triangle + leaf.count);
            continue;
        }
        const AabbTree::Node& node = tree.node(link);
        for (int i = 0; i < AabbTree::kWidth && node.low[0][i] <= node.high[0][i]; ++i) open.push_back(node.child[i]);
    }
    return triangles;
}

TEST(IncrementalSurface, ATraversalReachesTheVisibleTrianglesOfTheBaseOnly) {
    CutTooth patient(fineSphere());
    patient.cut(ballBur(0.4), at(0, 0, 0.2), at(0, 0, -0.4));
    const auto cut = patient.surface.snapshot();
    ASSERT_EQ(visibleBase(*cut).hidden, nullptr);
    std::set<std::uint32_t> visible;
    for (std::uint32_t t = 0; t < cut->base->mesh().triangles.size(); ++t)
        if (!isHidden(*cut->hidden, t)) visible.insert(t);
    EXPECT_LT(visible.size(), cut->base->mesh().triangles.size());
    EXPECT_EQ(reached(*cut), visible);

    Surface masked = *cut;
    masked.maskedTree = nullptr;
    std::mt19937 random(20261121);
    std::uniform_real_distribution<double> unit(-1, 1);
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 point = Vec3(0, 0, -0.2) + 0.6 * Vec3(unit(random), unit(random), unit(random));
        ASSERT_EQ(contains(*cut, point), contains(masked, point)) << point.transpose();
        inside += contains(*cut, point) ? 1 : 0;
    }
    EXPECT_GT(inside, 200);
    EXPECT_LT(inside, 1800);

    patient.surface.reset();
    EXPECT_EQ(reached(*patient.surface.snapshot()).size(), cut->base->mesh().triangles.size());
}

TEST(IncrementalSurface, RandomCuttingOfABallStaysClosed) {
    CutTooth patient(fineSphere());
    const std::vector<RevolutionEnvelope> burs = {flatBur(0.3), ballBur(0.25)};
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    double removed = 0;
    Pose pose = at(0, 0, 0.3);
    for (int i = 0; i < 40; ++i) {
        const Vec3 target(1.5 * unit(random), 1.5 * unit(random), -1.2 + 0.9 * unit(random));
        const Quat lean(Eigen::AngleAxisd(0.8 * unit(random), Vec3(unit(random), unit(random), 0).normalized()));
        const Pose next{pose.position + 0.3 * (target - pose.position), pose.rotation.slerp(0.3, lean)};
        removed += patient.cut(burs[i % 2], pose, next, 0.001);
        pose = next;
        if (i % 10 != 9) continue;
        EXPECT_EQ(badEdges(patient.mesh()), 0) << "after cut " << i;
    }
    EXPECT_EQ(patient.surface.failures(), 0U);
    const double lost = test::volumeOf(fineSphere()) - test::volumeOf(patient.mesh());
    EXPECT_NEAR(lost, removed, 0.005 * removed);
    EXPECT_GT(removed, 1.0);
}

TEST(IncrementalSurface, AThroughHoleStaysClosed) {
    CutTooth patient(test::box(Vec3(-2, -2, -1), Vec3(2, 2, 0)));
    patient.cut(flatBur(0.5), at(0.1, 0.2, 0.5), at(0.1, 0.2, -1.5));
    EXPECT_EQ(badEdges(patient.mesh()), 0);
    EXPECT_NEAR(16 - test::volumeOf(patient.mesh()), kPi * 0.25, 0.003 * kPi * 0.25);
}

TEST(IncrementalSurface, AThinWallBetweenTwoSlotsStaysClosed) {
    CutTooth patient(test::box(Vec3(-2, -2, -2), Vec3(2, 2, 0)));
    const auto bur = flatBur(0.3);
    for (const double gap : {0.08, 0.03, 0.01, -0.01}) {
        patient.cut(bur, at(-0.5, 0, 0.2), at(-0.5, 0, -0.5));
        patient.cut(bur, at(-0.5, 0, -0.5), at(0.5, 0, -0.5));
        patient.cut(bur, at(-0.5, 0.6 + gap, 0.2), at(0.5, 0.63 + gap, -0.5));
        EXPECT_EQ(badEdges(patient.mesh()), 0) << gap;
    }
}

TEST(IncrementalSurface, ManySmallStepsGiveTheSurfaceOfOneLongOne) {
    CutTooth steps(fineSphere());
    CutTooth once(fineSphere());
    const auto bur = ballBur(0.35);
    const auto point = [&](int i) { return at(-0.6 + 0.03 * i, 0, -0.5); };
    once.cut(bur, point(0), point(40));
    for (int i = 0; i < 40; ++i) steps.cut(bur, point(i), point(i + 1));
    EXPECT_EQ(badEdges(steps.mesh()), 0);
    EXPECT_NEAR(test::volumeOf(steps.mesh()), test::volumeOf(once.mesh()), 2e-4);
}

/// Depth of the deepest corner, edge middle or centre of the surface's triangles in a bur, mm, <= 0.
double deepestWithin(const TriangleMesh& mesh, const RevolutionEnvelope& bur, const Pose& toolInTooth) {
    const Pose toothInTool = toolInTooth.inverse();
    double deepest = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 a = mesh.corner(t, 0);
        const Vec3 b = mesh.corner(t, 1);
        const Vec3 c = mesh.corner(t, 2);
        for (const Vec3& point :
             {a, b, c, Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2), Vec3((a + b + c) / 3)}) {
            deepest = std::min(deepest, bur.signedDistance(toothInTool * point));
        }
    }
    return deepest;
}

TEST(IncrementalSurface, ABurAtRestInTheSlotThatItMilledDoesNotTouchTheWall) {
    for (const RevolutionEnvelope& bur : {flatBur(0.5), ballBur(0.4)}) {
        CutTooth patient(fineSphere());
        Pose pose{Vec3(-0.5, 0, 0.1), Quat(Eigen::AngleAxisd(0.1, Vec3(1, 2, 0).normalized()))};
        for (int i = 1; i <= 60; ++i) {
            Pose next = pose;
            next.position += i <= 30 ? Vec3(0, 0, -0.02) : Vec3(0.02, 0.004 * std::sin(0.4 * i), 0);
            patient.cut(bur, pose, next, kDefaultClearance * kVoxel);
            pose = next;
            if (i % 15 != 0) continue;
            EXPECT_GT(deepestWithin(patient.mesh(), bur, pose), -0.0005) << i;
        }
    }
}

TEST(IncrementalSurface, ATurningBurLeavesLessThanHalfAVoxelOnItsPath) {
    CutTooth patient(fineSphere());
    const auto bur = flatBur(0.5);
    Pose pose = at(0, 0, 0.3);
    double deepest = 0;
    for (int i = 1; i <= 40; ++i) {
        const Quat turn(Eigen::AngleAxisd(0.01 * i, Vec3(std::sin(0.3 * i), 1, 0).normalized()));
        const Pose next{Vec3(0.01 * i, 0.005 * i, 0.3 - 0.025 * i), turn};
        patient.cut(bur, pose, next, kDefaultClearance * kVoxel);
        pose = next;
        if (i % 10 == 0) deepest = std::min(deepest, deepestWithin(patient.mesh(), bur, pose));
    }
    EXPECT_GT(deepest, -0.5 * kVoxel);
}

TEST(IncrementalSurface, UpdatesOfWhatChangedAddUpToAnUpdateOfEverything) {
    CutTooth patient(fineSphere());
    const auto round = ballBur(0.3);
    const auto flat = flatBur(0.25);
    std::size_t changed = 0;
    std::size_t lowered = 0;
    for (int i = 1; i <= 60; ++i) {
        const Vec3 tip(-0.6 + 0.02 * i, 0.1 * std::sin(0.3 * i), -0.01 * i);
        const Pose from{tip, Quat(Eigen::AngleAxisd(0.01 * i, Vec3::UnitX()))};
        const Pose to{tip + Vec3(0.02, 0, -0.01), Quat(Eigen::AngleAxisd(0.01 * i + 0.01, Vec3::UnitX()))};
        const PlannedRemoval removable = patient.volume.removable(i % 2 == 0 ? round : flat, from, to);
        lowered += removable.where.size();
        const CarveResult result = patient.volume.carve(removable);
        changed += result.changed.size();
        patient.surface.update(patient.volume, result.changed);
    }
    EXPECT_LT(changed, lowered) << "bricks whose border stays as it is are left alone";

    IncrementalSurface anew(patient.volume);
    std::vector<ChangedBrick> all;
    for (const BrickKey& key : patient.volume.cutBricks()) all.push_back(ChangedBrick::all(key));
    anew.update(patient.volume, all);
    EXPECT_TRUE(test::areBitEqual(visibleMesh(*anew.snapshot()).mesh, patient.mesh()));
}

// The surface forgets triangles that a bur has passed. An undo brings them back.
TEST(IncrementalSurface, AfterAnUndoPassedTrianglesAreCutAgain) {
    CutTooth patient(fineSphere());
    const auto round = ballBur(0.3);
    const auto mill = [&](double y, int moves) {
        for (int i = 0; i < moves; ++i) patient.cut(round, at(-0.5 + 0.05 * i, y, -0.4), at(-0.45 + 0.05 * i, y, -0.4));
    };
    mill(-0.3, 8);
    const TriangleMesh before = patient.mesh();
    patient.volume.mark();
    mill(0.1, 20);
    const TriangleMesh after = patient.mesh();
    ASSERT_NE(before.triangles.size(), after.triangles.size());
    patient.surface.update(patient.volume, merged(patient.volume.undo()));
    EXPECT_TRUE(test::areBitEqual(patient.mesh(), before));
    mill(0.1, 20);
    EXPECT_TRUE(test::areBitEqual(patient.mesh(), after));
    EXPECT_EQ(patient.surface.failures(), 0U);
}

TEST(IncrementalSurface, IsTheSameFromOneThreadAndFromMany) {
    const auto cut = [] {
        CutTooth patient(fineSphere());
        patient.cut(ballBur(0.4), at(0, 0, 0.2), at(0.3, 0.1, -0.4));
        patient.cut(flatBur(0.3), at(0.5, 0, 0.2), at(0.2, 0.1, -0.9));
        return std::pair(patient.mesh(), patient.volume.hash());
    };
    const auto byMany = cut();
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    const auto byOne = cut();
    EXPECT_TRUE(test::areBitEqual(byOne.first, byMany.first));
    EXPECT_EQ(byOne.second, byMany.second);
}

TEST(IncrementalSurface, ASnapshotSharesWhatDidNotChange) {
    CutTooth patient(fineSphere());
    patient.cut(ballBur(0.3), at(-1, 0, 0), at(-1, 0, -0.5));
    const auto before = patient.surface.snapshot();
    patient.cut(ballBur(0.3), at(1, 0, 0), at(1, 0, -0.5));
    const auto after = patient.surface.snapshot();
    EXPECT_EQ(after->revision, before->revision + 1);
    EXPECT_EQ(after->base, before->base);
    const std::set<std::shared_ptr<const SurfacePart>> now(after->patches.begin(), after->patches.end());
    for (const auto& patch : before->patches) EXPECT_TRUE(now.contains(patch));
    EXPECT_GT(now.size(), before->patches.size());
}

TEST(IncrementalSurface, ARealToothCutToItsPulpIsWatertightInItsFile) {
    const auto folder = test::realTeethFolder();
    if (!folder) GTEST_SKIP() << "needs the layers of a real tooth; cut boxes and balls are tested above";
    const auto load = [&](const std::string& name) { return *readStl(*folder / name); };
    std::vector<LayerMesh> layers;
    for (const MaterialId id : {test::kEnamel, test::kDentin, test::kPulp}) {
        const std::string name = builtinMaterials().nameOf(id);
        layers.push_back({name, id, load("openmandible/layered/L6_" + name + ".stl")});
    }
    auto tooth = LayeredTooth::make(load("openmandible/whole/L6_whole.stl"), layers);
    ASSERT_TRUE(tooth);
    const double whole = test::volumeOf(tooth->outer()->mesh());
    const Box3 box = tooth->outer()->tree().box();
    CutVolume volume(std::make_shared<const LayeredTooth>(std::move(*tooth)), kVoxel);
    IncrementalSurface surface(volume);
    const auto bur = envelopeOf(load("tools/bur_tapered.stl"));
    MaterialVolumes removed{};
    for (int i = 0; i < 40; ++i) {
        const auto point = [&](int k) {
            return at(box.center().x() + 0.03 * std::max(0, k - 30), box.center().y(),
                      box.max().z() - 0.25 * std::min(k, 30));
        };
        const CarveResult result = volume.carve(bur, point(i), point(i + 1));
        surface.update(volume, result.changed);
        for (std::size_t m = 0; m < kMaxMaterials; ++m) removed[m] += result.removed[m];
    }
    for (const MaterialId id : {test::kEnamel, test::kDentin, test::kPulp}) {
        EXPECT_GT(removed[static_cast<std::size_t>(id)], 0.05) << builtinMaterials().nameOf(id);
    }
    const test::TemporaryFolder temporary;
    ASSERT_TRUE(writeStl(visibleMesh(*surface.snapshot()).mesh, temporary / "cut.stl"));
    const MeshReport report = reportOn(*readStl(temporary / "cut.stl"));
    EXPECT_TRUE(report.watertight());
    EXPECT_EQ(report.duplicateTriangles, 0U);
    EXPECT_EQ(report.duplicateTriangles, 0U);
    EXPECT_EQ(report.pinchedVertices, 0U);
    EXPECT_NEAR(whole - report.signedVolume, total(removed), 0.003 * total(removed));
}

TEST(IncrementalSurface, ResetShowsTheWholeToothAgain) {
    CutTooth patient(fineSphere());
    patient.cut(ballBur(0.3), at(0, 0, 0), at(0, 0, -0.5));
    patient.volume.reset();
    patient.surface.reset();
    expectSameTriangles(patient.mesh(), fineSphere());
    patient.cut(ballBur(0.3), at(0, 0, 0), at(0, 0, -0.5));
    EXPECT_EQ(badEdges(patient.mesh()), 0);
}

}  // namespace
}  // namespace tactooth
