// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/load_surface.h"

#include "geometry/mesh_edges.h"
#include "geometry/mesh_file.h"

namespace tactooth {
namespace {

bool isClosed(const TriangleMesh& mesh) {
    bool closed = true;
    MeshEdges(mesh).forEachEdge([&](const auto& uses) { closed &= uses.size() == 2; });
    return closed;
}

}  // namespace

Expected<std::shared_ptr<const Surface>> loadSurface(const std::filesystem::path& path, std::vector<Remark>* remarks) {
    Expected<TriangleMesh> mesh = loadMesh(path, remarks);
    if (!mesh) return Unexpected{mesh.error()};
    auto surface = std::make_shared<Surface>();
    surface->closed = isClosed(*mesh);
    surface->base = std::make_shared<const SurfacePart>(std::move(*mesh));
    return std::shared_ptr<const Surface>(std::move(surface));
}

Expected<std::shared_ptr<const ToolShape>> loadTool(const std::filesystem::path& path, std::vector<Remark>* remarks) {
    Expected<TriangleMesh> mesh = loadMesh(path, remarks);
    if (!mesh) return Unexpected{mesh.error()};
    return std::shared_ptr<const ToolShape>(std::make_shared<const ToolShape>(std::move(*mesh)));
}

}  // namespace tactooth
