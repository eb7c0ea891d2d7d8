// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The one file that includes OpenVDB, whose headers take a quarter of a minute and 700 MB to compile.
#include "session/io/vdb_file.h"

#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>

#include <sstream>

#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/display_text.h"
#include "geometry/util/parallel_for.h"
#include "session/io/messages.h"
#include "tooth/volume/remaining_fractions.h"

namespace tactooth {
namespace {

static_assert(openvdb::FloatTree::LeafNodeType::DIM == kBrickSide, "a brick becomes a leaf");

/// Number of bricks that are computed in parallel before one thread puts them into the grids.
constexpr std::size_t kBatch = 4096;

openvdb::Coord nodeOf(const BrickKey& key) { return {kBrickSide * key.x, kBrickSide * key.y, kBrickSide * key.z}; }

/// The library's archive writes only to named files. A file that appears when it is complete needs the bytes in memory.
class MemoryArchive : public openvdb::io::Archive {
public:
    [[nodiscard]] std::string bytesOf(const openvdb::GridCPtrVec& grids, const openvdb::MetaMap& metadata) const {
        std::ostringstream stream;
        write(stream, grids, true, metadata);
        return stream.str();
    }
};

class Grids {
public:
    Grids(const Lattice& lattice, const MaterialRegistry& materials) : lattice_(lattice) {
        for (const MaterialId id : materials.ids()) {
            const auto transform = openvdb::math::Transform::createLinearTransform(lattice.spacing());
            const Vec3 origin = lattice.node(0, 0, 0);
            transform->postTranslate({origin.x(), origin.y(), origin.z()});
            const openvdb::FloatGrid::Ptr grid = openvdb::FloatGrid::create(0.0F);
            grid->setTransform(transform);
            grid->setName(materials.nameOf(id));
            grid->setGridClass(openvdb::GRID_FOG_VOLUME);
            grids_.push_back(grid);
        }
    }

    void add(const SolidBlock& block) {
        const openvdb::Coord low = nodeOf(block.first);
        const int nodes = block.side * kBrickSide;
        const auto material = static_cast<std::size_t>(block.material);
        grids_[material]->sparseFill({low, low.offsetBy(nodes - 1)}, 1.0F, true);
        voxels_[material] += static_cast<double>(nodes) * nodes * nodes;
    }

    void add(const BrickKey& key, const BrickFractions& shares) {
        for (std::size_t m = 0; m < grids_.size(); ++m) {
            openvdb::FloatTree::LeafNodeType* leaf = nullptr;
            for (int node = 0; node < kBrickNodes; ++node) {
                const float share = shares[m][node];
                if (!(share > 0)) continue;
                if (leaf == nullptr) leaf = grids_[m]->tree().touchLeaf(nodeOf(key));
                const auto [x, y, z] = placeOf(node);
                leaf->setValueOn(openvdb::Coord(x, y, z), share);
                voxels_[m] += share;
            }
        }
    }

    /// The grids that are not empty, with their metadata.
    [[nodiscard]] openvdb::GridCPtrVec finished() const {
        const double spacing = lattice_.spacing();
        openvdb::GridCPtrVec filled;
        for (std::size_t m = 0; m < grids_.size(); ++m) {
            if (grids_[m]->empty()) continue;
            grids_[m]->insertMeta("unit", openvdb::StringMetadata("mm"));
            grids_[m]->insertMeta("quantity", openvdb::StringMetadata("share of the voxel that the material fills"));
            grids_[m]->insertMeta("volume_mm3", openvdb::DoubleMetadata(voxels_[m] * spacing * spacing * spacing));
            filled.push_back(grids_[m]);
        }
        return filled;
    }

private:
    const Lattice& lattice_;
    std::vector<openvdb::FloatGrid::Ptr> grids_;  // by MaterialId
    MaterialVolumes voxels_{};                    // voxels that each material fills
};

Grids gridsOf(const CutVolume& volume) {
    const RemainingFractions remains(volume);
    Grids grids(volume.lattice(), volume.tooth()->materials());
    for (const SolidBlock& block : remains.blocks()) grids.add(block);
    const std::vector<BrickKey>& keys = remains.mixed();
    std::vector<BrickFractions> shares(std::min(kBatch, keys.size()));
    for (std::size_t first = 0; first < keys.size(); first += kBatch) {
        const std::size_t count = std::min(kBatch, keys.size() - first);
        parallelFor(count, [&](std::size_t i) { shares[i] = remains.fractionsOf(keys[first + i]); });
        for (std::size_t i = 0; i < count; ++i) grids.add(keys[first + i], shares[i]);
    }
    return grids;
}

openvdb::MetaMap metadataOf(const Provenance& provenance) {
    std::string lines;
    for (const auto& [what, who] : provenance) lines.append(what).append(": ").append(who).append("\n");
    openvdb::MetaMap metadata;
    metadata.insertMeta("creator", openvdb::StringMetadata("Tactooth"));
    metadata.insertMeta("provenance", openvdb::StringMetadata(lines));
    return metadata;
}

}  // namespace

Expected<void> checkVdb() { return {}; }

Expected<void> writeVdb(const CutVolume& volume, const Provenance& provenance, const std::filesystem::path& path) {
    auto file = AtomicFile::create(path);
    if (!file) return Unexpected{file.error()};
    try {
        openvdb::initialize();
        file->write(MemoryArchive().bytesOf(gridsOf(volume).finished(), metadataOf(provenance)));
    } catch (const std::exception& error) {  // the library throws
        return unexpected(msg::kVdbNotWritten, displayName(path), displayText(error.what()));
    }
    return file->commit();
}

}  // namespace tactooth
