// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the readers of OBJ and PLY refuse them with a sentence, or give a surface that is valid and not
// larger than the bytes can hold.
#include <cstdlib>
#include <span>

#include "fuzz/fuzz_target.h"
#include "geometry/mesh_report.h"
#include "geometry/obj_reader.h"
#include "geometry/ply_reader.h"

namespace {

using namespace tactooth;

void require(bool holds) {
    if (!holds) std::abort();
}

void requirePromises(const Expected<TriangleMesh>& mesh, std::size_t bytes) {
    if (!mesh) {
        const std::string& sentence = mesh.error().message;
        require(sentence.starts_with("fuzz") && sentence.ends_with('.') && sentence.size() < 400);
        return;
    }
    require(!mesh->empty() && mesh->triangles.size() <= bytes && mesh->vertices.size() <= bytes);
    for (const Vec3f& vertex : mesh->vertices) require(vertex.allFinite());
    for (const Triangle& triangle : mesh->triangles) {
        for (const std::uint32_t vertex : triangle) require(vertex < mesh->vertices.size());
    }
    require(reportOn(*mesh).triangles == mesh->triangles.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    requirePromises(parseObj(bytes, "fuzz"), size);
    requirePromises(parsePly(bytes, "fuzz"), size);
    return 0;
}
