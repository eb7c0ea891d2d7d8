// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/load_surface.h"

#include "geometry/file_bytes.h"
#include "geometry/mesh_edges.h"
#include "geometry/mesh_file.h"
#include "geometry/mesh_reach.h"

namespace tactooth {
namespace {

bool isClosed(const TriangleMesh& mesh) {
    bool closed = true;
    MeshEdges(mesh).forEachEdge([&](const auto& uses) { closed &= uses.size() == 2; });
    return closed;
}

/// Whether it can be felt.
Expected<void> checkNear(const TriangleMesh& mesh, const std::filesystem::path& path) {
    const auto reach = checkReach(mesh, "the surface");
    if (reach) return {};
    return unexpected(shownName(path) + ": " + reach.error().message + ".");
}

}  // namespace

Expected<std::shared_ptr<const Surface>> loadSurface(const std::filesystem::path& path) {
    Expected<TriangleMesh> mesh = loadMesh(path);
    if (!mesh) return Unexpected{mesh.error()};
    if (auto near = checkNear(*mesh, path); !near) return Unexpected{near.error()};
    auto surface = std::make_shared<Surface>();
    surface->closed = isClosed(*mesh);
    surface->base = std::make_shared<const SurfacePart>(std::move(*mesh));
    return std::shared_ptr<const Surface>(std::move(surface));
}

Expected<std::shared_ptr<const ToolShape>> loadTool(const std::filesystem::path& path) {
    Expected<TriangleMesh> mesh = loadMesh(path);
    if (!mesh) return Unexpected{mesh.error()};
    if (auto near = checkNear(*mesh, path); !near) return Unexpected{near.error()};
    return std::shared_ptr<const ToolShape>(std::make_shared<const ToolShape>(std::move(*mesh)));
}

}  // namespace tactooth
