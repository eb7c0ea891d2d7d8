// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A surface from a file.
struct ReadMesh {
    TriangleMesh mesh;
    /// The offset that was subtracted from the coordinates before they were rounded to single precision, in the file's
    /// unit: mesh + offset is the surface in the file's frame. Zero unless the surface is so far from the origin that
    /// single precision would distort it.
    Vec3 offset = Vec3::Zero();
    std::vector<ImportNote> importNotes = {};  ///< what was skipped or changed; the first value is the file's name
};

}  // namespace tactooth
