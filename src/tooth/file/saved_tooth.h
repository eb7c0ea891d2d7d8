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
    MaterialId body = MaterialId::Enamel;
    ToothContext toothContext;
    double voxel = 0;           ///< mm
    MaterialVolumes removed{};  ///< mm^3
    std::map<BrickKey, CutField> cuts;
    Provenance provenance;
};

/// A cut tooth as the bytes of a file (docs/tooth-file.md).
[[nodiscard]] std::vector<std::byte> savedToothBytes(const CutVolume& volume, const MaterialVolumes& removed,
                                                     const Provenance& provenance);

/// Reads such bytes; `name` stands for the file in messages. Fails with one sentence with the byte's place if anything
/// is not as a writer leaves it.
[[nodiscard]] Expected<SavedTooth> parseSavedTooth(std::span<const std::byte> bytes, const std::string& name);

}  // namespace tactooth
