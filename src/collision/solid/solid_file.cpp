// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/solid_file.h"

#include <algorithm>
#include <iterator>

#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_file.h"

namespace tactooth {

Expected<TriangleMesh> solidFrom(TriangleMesh mesh, const std::string& name, const std::string& what,
                                 const SolidOptions& options, std::vector<Remark>* remarks) {
    ExaminedSolid examined = examineSolid(std::move(mesh), options);
    if (!examined.report.isSolid()) return unexpected(name + ": " + flawSentence(examined.report, what) + ".");
    if (remarks != nullptr) std::ranges::move(remarksOn(examined.report, name), std::back_inserter(*remarks));
    return std::move(examined.mesh);
}

Expected<TriangleMesh> loadSolid(const std::filesystem::path& file, const std::string& what,
                                 const SolidOptions& options, std::vector<Remark>* remarks) {
    std::vector<Remark> done;
    Expected<TriangleMesh> mesh = loadMesh(file, &done);
    if (!mesh) return mesh;
    auto solid = solidFrom(std::move(*mesh), shownName(file), what, options, &done);
    if (remarks == nullptr) return solid;
    for (Remark& remark : done) {
        remark.values.front() = shownName(file.filename());  // remarks are saved with a tooth: no paths
        remarks->push_back(std::move(remark));
    }
    return solid;
}

}  // namespace tactooth
