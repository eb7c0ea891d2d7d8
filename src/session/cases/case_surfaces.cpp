// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_surfaces.h"

#include <algorithm>
#include <optional>

#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_file.h"
#include "geometry/util/lower_case.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"
#include "session/cases/case_names.h"
#include "session/cases/case_store.h"
#include "session/cases/entry_name.h"
#include "session/cases/messages.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

bool isSurfaceFile(const fs::path& path) {
    const std::string ending = toLowerCase(path.extension().string());
    return ending == ".stl" || ending == ".obj" || ending == ".ply";
}

/// All surfaces of the paths, sorted, without system files.
Expected<std::vector<fs::path>> surfaceFiles(const std::vector<fs::path>& from) {
    std::vector<fs::path> files;
    for (const fs::path& path : from) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            files.push_back(path);
            continue;
        }
        for (fs::recursive_directory_iterator at(path, error), end; !error && at != end; at.increment(error)) {
            if (isSystemFile(at->path().filename().string())) {
                at.disable_recursion_pending();
            } else if (isSurfaceFile(at->path()) && at->is_regular_file(error)) {
                files.push_back(at->path());
            }
            if (files.size() > kCaseLimits.entries) {
                return unexpected(msg::kCaseOfTooMuch, displayName(path));
            }
        }
        if (error) return unexpected(msg::kFolderNotRead, displayName(path), systemReason(error));
    }
    std::ranges::sort(files);
    if (files.empty()) return unexpected(msg::kCaseOfNothing);
    return files;
}

}  // namespace

void translateMesh(TriangleMesh& mesh, const Vec3& step) {
    if (step.isZero(0)) return;
    for (Vec3f& vertex : mesh.vertices) vertex = (vertex.cast<double>() + step).cast<float>();
}

Expected<CaseSurfaces> readCaseSurfaces(const std::vector<fs::path>& from, const MaterialRegistry& materials) {
    const auto files = surfaceFiles(from);
    if (!files) return Unexpected{files.error()};
    CaseSurfaces surfaces;
    std::map<std::string, Scan> byName;
    std::optional<Vec3> common;  // all surfaces stay in one frame
    for (const fs::path& file : *files) {
        auto read = readMesh(file);
        if (!read) return Unexpected{read.error()};
        if (!common) common = read->offset;
        translateMesh(read->mesh, read->offset - *common);
        const NamedSurface named = surfaceNamed(file, materials);
        std::vector<ImportNote>& importNotes =
            named.isAdjacent ? surfaces.aroundImportNotes[named.body] : byName[named.body].importNotes;
        importNotes.insert(importNotes.end(), read->importNotes.begin(), read->importNotes.end());
        if (!named.isAdjacent) byName[named.body].materials = &materials;
        const bool isNew = named.isAdjacent ? surfaces.around.emplace(named.body, std::move(read->mesh)).second
                                            : addSurface(byName[named.body], named.material, std::move(read->mesh));
        if (!isNew) {
            return unexpected(msg::kCaseSurfaceTwice, displayName(file));
        }
        surfaces.files.push_back(file.filename().string());
    }
    if (byName.empty()) return unexpected(msg::kCaseWithoutTooth);
    for (auto& [name, scan] : byName) {
        scan.name = name;
        surfaces.teeth.push_back(std::move(scan));
    }
    return surfaces;
}

}  // namespace tactooth
