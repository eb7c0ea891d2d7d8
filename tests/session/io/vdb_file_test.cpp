// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// OpenVDB itself reads the files.
#include "session/io/vdb_file.h"

#include <gtest/gtest.h>
#include <openvdb/openvdb.h>

#include <map>
#include <random>

#include "bench_scene.h"
#include "collision/bvh/closest_point.h"
#include "geometry/files/file_bytes.h"
#include "support/materials.h"
#include "support/mesh_checks.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::at;
using test::cutBlock;

const Provenance kNotes = {{"tooth", "block.stl"}, {"saved", "today"}, {"saved", "and once more"}};
constexpr double kBlock = 48;  // mm^3
constexpr double kCore = 6.8;  // mm^3
constexpr double kVoxelVolume = test::kVoxel * test::kVoxel * test::kVoxel;

/// A file read by the library: the grids by name.
struct Read {
    explicit Read(const std::filesystem::path& path) {
        openvdb::initialize();
        openvdb::io::File file(path.string());
        file.open();
        metadata = file.getMetadata();
        const openvdb::GridPtrVecPtr all = file.getGrids();
        for (const openvdb::GridBase::Ptr& grid : *all) {
            grids[grid->getName()] = openvdb::gridPtrCast<openvdb::FloatGrid>(grid);
        }
    }
    [[nodiscard]] double voxelsOf(const std::string& name) const {
        double sum = 0;
        for (auto value = grids.at(name)->cbeginValueOn(); value; ++value) {
            sum += static_cast<double>(*value) * static_cast<double>(value.getVoxelCount());
        }
        return sum;
    }
    /// Share of the voxel at a node of the lattice.
    [[nodiscard]] double at(const std::string& name, const openvdb::Coord& node) const {
        return grids.at(name)->tree().getValue(node);
    }

    openvdb::MetaMap::Ptr metadata;
    std::map<std::string, openvdb::FloatGrid::Ptr> grids;
};

class VdbFile : public ::testing::Test {
protected:
    Read written(const CutModel& piece) {
        const auto done = writeVdb(piece.volume(), kNotes, folder_ / "cut.vdb");
        EXPECT_TRUE(done) << done.error().message();
        return Read(folder_ / "cut.vdb");
    }
    test::TemporaryFolder folder_;
};

TEST_F(VdbFile, HoldsTheVolumeOfEachMaterialThatIsLeft) {
    const auto piece = cutBlock();
    const Read read = written(*piece);
    ASSERT_EQ(read.grids.size(), 2U);
    const auto removed = [&](MaterialId id) { return piece->removed()[static_cast<std::size_t>(id)]; };
    const double enamel = kBlock - kCore - removed(test::kEnamel);
    const double dentin = kCore - removed(test::kDentin);
    EXPECT_NEAR(read.voxelsOf("enamel") * kVoxelVolume, enamel, 0.003 * enamel);
    EXPECT_NEAR(read.voxelsOf("dentin") * kVoxelVolume, dentin, 0.003 * dentin);
    const double left = test::volumeOf(visibleMesh(*piece->surface()).mesh);
    EXPECT_NEAR((read.voxelsOf("enamel") + read.voxelsOf("dentin")) * kVoxelVolume, left, 0.003 * left);
    EXPECT_GT(removed(test::kDentin), 0.1);
}

TEST_F(VdbFile, SaysOfEachGridWhatItIs) {
    const auto piece = cutBlock();
    const Read read = written(*piece);
    for (const auto& [name, grid] : read.grids) {
        EXPECT_EQ(grid->getGridClass(), openvdb::GRID_FOG_VOLUME) << name;
        EXPECT_EQ(grid->background(), 0.0F) << name;
        EXPECT_EQ(grid->metaValue<std::string>("unit"), "mm") << name;
        EXPECT_NEAR(grid->metaValue<double>("volume_mm3"), read.voxelsOf(name) * kVoxelVolume, 1e-9) << name;
    }
    EXPECT_EQ(read.metadata->metaValue<std::string>("creator"), "Tactooth");
    EXPECT_EQ(read.metadata->metaValue<std::string>("provenance"),
              "tooth: block.stl\nsaved: today\nsaved: and once more\n");
}

TEST_F(VdbFile, VoxelsLieWhereTheSurfaceIs) {
    const auto piece = cutBlock();
    const Read read = written(*piece);
    const auto& transform = read.grids.at("enamel")->transform();
    EXPECT_NEAR(transform.voxelSize().x(), test::kVoxel, 1e-12);
    std::mt19937 random(7);
    const auto place = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    int inside = 0;
    int checked = 0;
    for (int i = 0; i < 4000; ++i) {
        const openvdb::Coord node(place(-45, 45), place(-45, 45), place(-65, 5));
        const openvdb::Vec3d world = transform.indexToWorld(node);
        const Vec3 point(world.x(), world.y(), world.z());
        double nearest = std::numeric_limits<double>::infinity();
        const Surface& surface = *piece->surface();
        for (const auto& part : surface.patches) {
            if (const auto hit = closestPoint(*part, point, 0.1)) nearest = std::min(nearest, hit->distance);
        }
        if (const auto hit = closestPoint(*surface.base, point, 0.1)) nearest = std::min(nearest, hit->distance);
        const double share = read.at("enamel", node) + read.at("dentin", node);
        ASSERT_GE(share, 0);
        ASSERT_LE(share, 1.00001);
        if (nearest < 0.87 * test::kVoxel) continue;
        ++checked;
        const bool isSolid = contains(surface, point);
        inside += isSolid ? 1 : 0;
        ASSERT_NEAR(share, isSolid ? 1 : 0, 1e-5) << point.transpose();
        if (!isSolid) continue;
        const bool isCore = Box3(Vec3(-0.95, -0.95, -1.95), Vec3(0.95, 0.95, -0.35)).contains(point);
        if (isCore) {
            ASSERT_NEAR(read.at("dentin", node), 1, 1e-5) << point.transpose();
        }
    }
    EXPECT_GT(checked, 3000);
    EXPECT_GT(inside, checked * 3 / 10);
    EXPECT_LT(inside, checked * 8 / 10);
}

TEST_F(VdbFile, AnUncutToothIsWhole) {
    auto tooth = LayeredTooth::make(test::sphere(Vec3(0.1, 0.2, 0.3), 2, 96, 64), {}, test::kDentin);
    const double whole = test::volumeOf(tooth->outer()->mesh());
    const CutModel piece(std::make_shared<const LayeredTooth>(std::move(*tooth)), 0.04);
    const Read read = written(piece);
    ASSERT_EQ(read.grids.size(), 1U);
    EXPECT_NEAR(read.voxelsOf("dentin") * 0.04 * 0.04 * 0.04, whole, 0.0005 * whole);
}

TEST_F(VdbFile, TheSameToothGivesTheSameVoxels) {
    const auto piece = cutBlock();
    const Read first = written(*piece);
    const Read second = written(*piece);
    for (const auto& [name, grid] : first.grids) {
        const auto& other = *second.grids.at(name);
        EXPECT_EQ(grid->activeVoxelCount(), other.activeVoxelCount());
        for (auto value = grid->cbeginValueOn(); value; ++value) {
            ASSERT_EQ(*value, other.tree().getValue(value.getCoord()));
        }
    }
}

TEST_F(VdbFile, LeavesNothingWhereItCannotWrite) {
    const auto piece = cutBlock();
    const auto done = writeVdb(piece->volume(), kNotes, folder_ / "no/cut.vdb");
    ASSERT_FALSE(done);
    EXPECT_NE(done.error().message().find("make the folder first"), std::string::npos) << done.error().message();
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace tactooth
