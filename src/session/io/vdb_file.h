// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/util/expected.h"
#include "tooth/file/saved_tooth.h"

namespace tactooth {

/// Fails with one sentence if this program was built without OpenVDB, which is optional.
[[nodiscard]] Expected<void> checkVdb();

/// Fails, before any memory is allocated, if the file of this tooth would exceed 4 GB. `voxel`: spacing, mm.
[[nodiscard]] Expected<void> checkVdbSize(const LayeredTooth& tooth, double voxel);

/// Writes the remaining tooth as an OpenVDB file (docs/vdb-file.md): one grid of floats for each material, named after
/// it. A value is the share of the voxel that the material fills, 0..1. The file appears when it is complete.
[[nodiscard]] Expected<void> writeVdb(const CutVolume& volume, const Provenance& provenance,
                                      const std::filesystem::path& path);

}  // namespace tactooth
