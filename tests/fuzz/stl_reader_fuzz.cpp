// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the STL reader refuses them with a sentence, or gives a surface that is valid and survives being
// written and read again.
#include "fuzz/fuzz_target.h"
#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"

namespace tactooth::test {
namespace {

void requireSame(const TriangleMesh& mesh, const Expected<TriangleMesh>& back) {
    require(back && back->triangles == mesh.triangles && back->vertices == mesh.vertices,
            "what was read can be written and read again");
}

bool accepts(std::span<const std::byte> bytes) {
    const Expected<TriangleMesh> mesh = parseStl(bytes, "fuzz");
    if (!mesh) return requireSentence(mesh.error()), false;
    require(!mesh->empty() && mesh->vertices.size() <= 3 * mesh->triangles.size(), "a surface has triangles");
    requireValid(*mesh);
    const MeshReport report = reportOn(*mesh);
    require(report.triangles == mesh->triangles.size() && report.vertices <= mesh->vertices.size(),
            "the report counts what is there");
    requireSame(*mesh, parseStl(stlBytes(*mesh, StlFormat::Binary), "again"));
    requireSame(*mesh, parseStl(stlBytes(*mesh, StlFormat::Ascii), "again"));
    return true;
}

const AddFuzzTarget added({"stl", accepts});

}  // namespace
}  // namespace tactooth::test
