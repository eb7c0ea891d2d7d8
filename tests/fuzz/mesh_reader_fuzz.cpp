// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the readers of OBJ and PLY refuse them with a sentence, or give a surface that is valid and not
// larger than the bytes can hold.
#include "fuzz/fuzz_target.h"
#include "geometry/io/obj_reader.h"
#include "geometry/io/ply_reader.h"
#include "geometry/mesh/mesh_report.h"

namespace tactooth::test {
namespace {

bool keepsPromises(const Expected<ReadMesh>& read, std::size_t bytes) {
    if (!read) return requireSentence(read.error()), false;
    const TriangleMesh* const mesh = &read->mesh;
    for (const ImportNote& importNote : read->importNotes) requireSentence(importNote.message);
    require(!mesh->empty() && mesh->triangles.size() <= bytes && mesh->vertices.size() <= bytes,
            "a surface is no larger than its file");
    requireValid(*mesh);
    require(reportOn(*mesh).triangles == mesh->triangles.size(), "the report counts what is there");
    return true;
}

bool accepts(std::span<const std::byte> bytes) {
    const bool isObj = keepsPromises(parseObj(bytes, "fuzz"), bytes.size());
    const bool isPly = keepsPromises(parsePly(bytes, "fuzz"), bytes.size());
    return isObj || isPly;
}

const AddFuzzTarget added({"mesh", accepts});

}  // namespace
}  // namespace tactooth::test
