// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"
#include "patient/scan_import.h"

namespace tactooth {

/// The surfaces of a new case as their files hold them, all in the frame of the first file less its offset (see
/// ReadMesh).
struct CaseSurfaces {
    std::vector<Scan> teeth;                                           ///< at least one, by name
    std::map<std::string, TriangleMesh> around;                        ///< by name
    std::map<std::string, std::vector<ImportNote>> aroundImportNotes;  ///< from reading them
    std::vector<std::string> files;                                    ///< names, in the order of reading
};

/// Moves every vertex, to bring surfaces with different offsets into one frame.
void translateMesh(TriangleMesh& mesh, const Vec3& step);

/// Reads surfaces and all surfaces below folders, sorted by their names (surfaceNamed), so that equal folders give
/// equal cases. Skips hidden and system files. Fails with one sentence if there is no tooth, or a surface twice.
[[nodiscard]] Expected<CaseSurfaces> readCaseSurfaces(const std::vector<std::filesystem::path>& from,
                                                      const MaterialRegistry& materials = builtinMaterials());

}  // namespace tactooth
