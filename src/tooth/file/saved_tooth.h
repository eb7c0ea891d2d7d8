// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/util/expected.h"
#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// Where a saved tooth comes from: what and who, in the order in which it happened.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// All that a saved tooth is made of: the surfaces as they were before the first cut, bit for bit, and what was cut.
struct SavedTooth {
    TriangleMesh outer;
    std::vector<LayerMesh> layers;
    /// What the MaterialIds of the layers, the body and the removed volumes mean: the registry that the reader was
    /// given, and behind its materials those of the file that it does not know.
    const MaterialRegistry* materials = nullptr;
    std::vector<std::string> unknownMaterials;  ///< names of the latter; they take the numbers of the surroundings
    MaterialId body{};
    ToothContext toothContext;
    double voxel = 0;           ///< mm
    MaterialVolumes removed{};  ///< mm^3
    std::map<BrickKey, CutField> cuts;
    Provenance provenance;
};

/// A cut tooth as the bytes of a file (docs/tooth-file.md).
[[nodiscard]] std::vector<std::byte> savedToothBytes(const CutVolume& volume, const MaterialVolumes& removed,
                                                     const Provenance& provenance);

/// Reads such bytes; `name` stands for the file in messages. The names of the materials in the file are looked up in
/// `materials`. Fails with one sentence with the byte's place if anything is not as a writer leaves it.
[[nodiscard]] Expected<SavedTooth> parseSavedTooth(std::span<const std::byte> bytes, const std::string& name,
                                                   const MaterialRegistry& materials = builtinMaterials());

}  // namespace tactooth
