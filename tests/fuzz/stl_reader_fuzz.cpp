// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the STL reader refuses them with a sentence, or gives a surface that is valid and survives being
// written and read again.
#include <cmath>
#include <cstdlib>
#include <span>

#include "fuzz/fuzz_target.h"
#include "geometry/mesh_report.h"
#include "geometry/stl_reader.h"
#include "geometry/stl_writer.h"

namespace {

using namespace tactooth;

void require(bool holds) {
    if (!holds) std::abort();
}

void requireValid(const TriangleMesh& mesh) {
    require(!mesh.empty() && mesh.vertices.size() <= 3 * mesh.triangles.size());
    for (const Vec3f& vertex : mesh.vertices) require(vertex.allFinite());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) require(vertex < mesh.vertices.size());
    }
}

void requireSame(const TriangleMesh& mesh, const Expected<TriangleMesh>& back) {
    require(back && back->triangles == mesh.triangles && back->vertices == mesh.vertices);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Expected<TriangleMesh> mesh = parseStl(std::as_bytes(std::span(data, size)), "fuzz");
    if (!mesh) {
        const std::string& sentence = mesh.error().message;
        require(sentence.starts_with("fuzz") && sentence.ends_with('.') && sentence.size() < 400);
        return 0;
    }
    requireValid(*mesh);
    const MeshReport report = reportOn(*mesh);
    require(report.triangles == mesh->triangles.size() && report.vertices <= mesh->vertices.size());
    requireSame(*mesh, parseStl(stlBytes(*mesh, StlFormat::Binary), "again"));
    requireSame(*mesh, parseStl(stlBytes(*mesh, StlFormat::Ascii), "again"));
    return 0;
}
