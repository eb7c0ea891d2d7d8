// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/load_surface.h"

#include <algorithm>
#include <iterator>

#include "collision/solid/solid.h"
#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_file.h"
#include "geometry/mesh/mesh_extent.h"
#include "geometry/util/assert.h"
#include "geometry/util/messages.h"
#include "tooth/model/messages.h"

namespace tactooth {

namespace {

/// Fails if the surface is empty or too far away to touch.
Expected<void> checkNear(const TriangleMesh& mesh, const std::filesystem::path& path) {
    const auto reach = checkExtent(mesh, msg::kTheSurface);
    if (reach) return {};
    return unexpected(msg::kNamed, displayName(path), reach.error());
}

}  // namespace

Expected<std::shared_ptr<const Surface>> loadSurface(const std::filesystem::path& path,
                                                     std::vector<ImportNote>* importNotes) {
    Expected<TriangleMesh> mesh = loadMesh(path, importNotes);
    if (!mesh) return Unexpected{mesh.error()};
    if (auto near = checkNear(*mesh, path); !near) return Unexpected{near.error()};
    ExaminedSolid examined = examineSolid(std::move(*mesh));
    const SolidFlaw flaw = examined.report.flaw;
    // An open surface can still be touched.
    if (flaw != SolidFlaw::None && flaw != SolidFlaw::Open && flaw != SolidFlaw::NonOrientable) {
        return unexpected(msg::kNamed, displayName(path),
                          flawSentence(examined.report, {msg::kSurfaceOf, msg::kTheTooth}));
    }
    if (importNotes != nullptr) {
        std::ranges::move(notesOn(examined.report, Message::verbatim(displayName(path))),
                          std::back_inserter(*importNotes));
    }
    auto surface = std::make_shared<Surface>();
    surface->closed = examined.report.isSolid();
    surface->base = std::make_shared<const SurfacePart>(std::move(examined.mesh));
    TACTOOTH_ASSERT(!surface->base->mesh().triangles.empty());
    return std::shared_ptr<const Surface>(std::move(surface));
}

Expected<std::shared_ptr<const ToolShape>> loadTool(const std::filesystem::path& path,
                                                    std::vector<ImportNote>* importNotes) {
    Expected<TriangleMesh> mesh = loadMesh(path, importNotes);
    if (!mesh) return Unexpected{mesh.error()};
    if (auto near = checkNear(*mesh, path); !near) return Unexpected{near.error()};
    return std::shared_ptr<const ToolShape>(std::make_shared<const ToolShape>(std::move(*mesh)));
}

}  // namespace tactooth
