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

/// The surfaces that a new case is made of, as their files hold them, all in one frame (that of the first, less its
/// offset; see ReadMesh).
struct CaseSurfaces {
    std::vector<Scan> teeth;                                           ///< at least one, by name
    std::map<std::string, TriangleMesh> around;                        ///< by name
    std::map<std::string, std::vector<ImportNote>> aroundImportNotes;  ///< on reading them
    std::vector<std::string> files;  ///< their names, in the order in which they were read
};

/// Moves every vertex: two surfaces that were read with offsets of their own come into one frame.
void translateMesh(TriangleMesh& mesh, const Vec3& step);

/// Reads surfaces and all surfaces below folders, and sorts them by their names (surfaceNamed), so that the same folder
/// gives the same case. Hidden files and others that a system puts into folders are passed over. Fails with one
/// sentence if there is no tooth, or a surface twice.
[[nodiscard]] Expected<CaseSurfaces> readCaseSurfaces(const std::vector<std::filesystem::path>& from,
                                                      const MaterialRegistry& materials = builtinMaterials());

}  // namespace tactooth
