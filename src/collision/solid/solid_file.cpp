// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/solid_file.h"

#include <algorithm>
#include <iterator>

#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_file.h"
#include "geometry/util/assert.h"
#include "geometry/util/messages.h"

namespace tactooth {

Expected<TriangleMesh> solidFrom(TriangleMesh mesh, const std::string& name, const Message& what,
                                 const SolidOptions& options, std::vector<ImportNote>* importNotes) {
    ExaminedSolid examined = examineSolid(std::move(mesh), options);
    if (!examined.report.isSolid()) return unexpected(msg::kNamed, name, flawSentence(examined.report, what));
    if (importNotes != nullptr)
        std::ranges::move(notesOn(examined.report, Message::verbatim(name)), std::back_inserter(*importNotes));
    return std::move(examined.mesh);
}

Expected<TriangleMesh> loadSolid(const std::filesystem::path& file, const Message& what, const SolidOptions& options,
                                 std::vector<ImportNote>* importNotes) {
    std::vector<ImportNote> done;
    Expected<TriangleMesh> mesh = loadMesh(file, &done);
    if (!mesh) return mesh;
    auto solid = solidFrom(std::move(*mesh), displayName(file), what, options, &done);
    if (importNotes == nullptr) return solid;
    for (ImportNote& importNote : done) {
        importNote.message.replaceFirst(displayName(file.filename()));  // notes are saved with a tooth: no paths
        importNotes->push_back(std::move(importNote));
    }
    return solid;
}

}  // namespace tactooth
