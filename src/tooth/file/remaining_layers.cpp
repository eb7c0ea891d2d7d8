// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/file/remaining_layers.h"

#include "geometry/util/assert.h"
#include "tooth/file/exported_mesh.h"
#include "tooth/surface/incremental_surface.h"

namespace tactooth {
namespace {

/// Cuts a layer as if it were a tooth of its own, with the cut field of the whole tooth.
TriangleMesh remainsOf(const TriangleMesh& layer, double voxel, const std::map<BrickKey, CutField>& cuts) {
    auto tooth = LayeredTooth::make(layer);
    TACTOOTH_ASSERT(tooth.has_value());
    if (!tooth) return {};  // cannot happen: the layer was checked when the tooth was made
    CutVolume volume(std::make_shared<const LayeredTooth>(std::move(*tooth)), voxel);
    IncrementalSurface surface(volume);
    surface.update(volume, volume.adopt(cuts));
    return exportedMesh(*surface.snapshot(), voxel).mesh;
}

}  // namespace

std::vector<std::string> remainingLayerNames(const LayeredTooth& tooth) {
    std::vector<std::string> names;
    for (const LayeredTooth::Layer& layer : tooth.layers()) names.push_back(layer.name);
    if (names.empty()) names.push_back(tooth.materials().nameOf(tooth.body()));
    return names;
}

std::vector<RemainingLayer> remainingLayers(const CutVolume& volume) {
    std::map<BrickKey, CutField> cuts;
    for (const BrickKey& key : volume.cutBricks()) cuts.emplace_hint(cuts.end(), key, *volume.bricks().find(key));
    const LayeredTooth& tooth = *volume.tooth();
    const double voxel = volume.lattice().spacing();
    std::vector<RemainingLayer> remains;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        remains.push_back({layer.name, remainsOf(layer.part->mesh(), voxel, cuts)});
    }
    if (remains.empty()) {
        remains.push_back({tooth.materials().nameOf(tooth.body()), remainsOf(tooth.outer()->mesh(), voxel, cuts)});
    }
    TACTOOTH_ASSERT(!remains.empty());
    return remains;
}

}  // namespace tactooth
