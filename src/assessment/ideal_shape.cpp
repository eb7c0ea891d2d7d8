// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/ideal_shape.h"

#include "assessment/messages.h"
#include "collision/solid/solid_file.h"
#include "geometry/mesh/vertex_welder.h"
#include "session/simulation/tooth_file.h"

namespace tactooth {

TriangleMesh asReadFromFile(const Surface& tooth) {
    const TriangleMesh mesh = visibleToothMesh(tooth).mesh;
    std::vector<Vec3f> corners;
    corners.reserve(3 * mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) corners.push_back(mesh.vertices[vertex]);
    }
    return weld(corners);
}

Expected<TriangleMesh> loadIdealShape(const std::filesystem::path& file, std::vector<ImportNote>* importNotes) {
    if (!isToothFile(file)) return loadSolid(file, msg::kIdealShape, {}, importNotes);
    const Expected<OpenedTooth> opened = openTooth(file);
    if (!opened) return Unexpected{opened.error()};
    return asReadFromFile(*opened->piece->surface());
}

}  // namespace tactooth
