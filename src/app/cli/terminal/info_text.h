// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "collision/solid/solid.h"
#include "geometry/io/import_note.h"
#include "geometry/mesh/mesh_report.h"

namespace tactooth {

/// The properties of a surface, as its file stores it and as every command uses it (`examineSolid`).
struct SurfaceFacts {
    std::size_t storedTriangles = 0;
    bool storedInsideOut = false;
    bool storedOriented = true;
    MeshReport used;
    SolidReport solid;
    std::optional<double> crownTilt = {};  ///< of a solid, as tactooth::crownTilt
    std::vector<ImportNote> reading = {};  ///< from reading the file

    /// Weaknesses and repairs, one sentence each; empty for a sound surface.
    [[nodiscard]] std::vector<std::string> findings() const;
};

[[nodiscard]] SurfaceFacts surfaceFacts(const TriangleMesh& mesh);

/// The facts as a text table, or as one line of JSON. `name`: of the file.
[[nodiscard]] std::string infoTable(std::string_view name, const SurfaceFacts& facts);
[[nodiscard]] std::string infoJson(std::string_view name, const SurfaceFacts& facts);

}  // namespace tactooth
