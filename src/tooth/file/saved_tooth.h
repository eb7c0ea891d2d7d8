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

/// History of a saved tooth: pairs of key and value, in the order of the events.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// The contents of a saved tooth: the surfaces before the first cut, bit for bit, and the cut fields.
struct SavedTooth {
    TriangleMesh outer;
    std::vector<LayerMesh> layers;
    /// What the MaterialIds of the layers, the body and the removed volumes mean: the registry that the reader was
    /// given, and behind its materials those of the file that it does not know.
    const MaterialRegistry* materials = nullptr;
    /// Names of those of the latter of which the file says no more; they take the numbers of the surroundings.
    std::vector<std::string> unknownMaterials;
    MaterialId body{};
    ToothContext toothContext;
    double voxel = 0;           ///< mm
    MaterialVolumes removed{};  ///< mm^3
    std::map<BrickKey, CutField> cuts;
    Provenance provenance;
    std::string work;  ///< what somebody was doing with it, as a text of the layer above; empty: nothing
};

/// Writes a cut tooth as the bytes of a file (docs/tooth-file.md). `work`: at most 4 MiB.
[[nodiscard]] std::vector<std::byte> savedToothBytes(const CutVolume& volume, const MaterialVolumes& removed,
                                                     const Provenance& provenance, const std::string& work = {});

/// Reads such bytes. Messages name the file `name`. The names of the materials in the file are looked up in
/// `materials`. Fails with one sentence that names the position of the byte, if the bytes are not as
/// savedToothBytes writes them.
[[nodiscard]] Expected<SavedTooth> parseSavedTooth(std::span<const std::byte> bytes, const std::string& name,
                                                   const MaterialRegistry& materials = builtinMaterials());

}  // namespace tactooth
