// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/util/expected.h"
#include "tooth/file/saved_tooth.h"

namespace tactooth {

/// Nothing if this program can write OpenVDB files, else why not, in one sentence: OpenVDB is not among what has to be
/// there to build it.
[[nodiscard]] Expected<void> checkVdb();

/// Fails, before memory is taken, if the file of this tooth would hold more than 4 GB. `voxel`: spacing, mm.
[[nodiscard]] Expected<void> checkVdbSize(const LayeredTooth& tooth, double voxel);

/// Writes what is left of a tooth for OpenVDB: one grid of floats for each material, named after it, that says how much
/// of each voxel it fills, 0..1; docs/vdb-file.md. The file appears when it is complete.
[[nodiscard]] Expected<void> writeVdb(const CutVolume& volume, const Provenance& provenance,
                                      const std::filesystem::path& path);

}  // namespace tactooth
