// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/load_surface.h"

#include <algorithm>
#include <iterator>

#include "collision/solid/solid.h"
#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_file.h"
#include "geometry/mesh/mesh_reach.h"

namespace tactooth {

namespace {

/// Whether it can be felt.
Expected<void> checkNear(const TriangleMesh& mesh, const std::filesystem::path& path) {
    const auto reach = checkReach(mesh, "the surface");
    if (reach) return {};
    return unexpected(shownName(path) + ": " + reach.error().message + ".");
}

}  // namespace

Expected<std::shared_ptr<const Surface>> loadSurface(const std::filesystem::path& path, std::vector<Remark>* remarks) {
    Expected<TriangleMesh> mesh = loadMesh(path, remarks);
    if (!mesh) return Unexpected{mesh.error()};
    if (auto near = checkNear(*mesh, path); !near) return Unexpected{near.error()};
    ExaminedSolid examined = examineSolid(std::move(*mesh));
    const SolidFlaw flaw = examined.report.flaw;
    // What is open can still be felt.
    if (flaw != SolidFlaw::None && flaw != SolidFlaw::Open && flaw != SolidFlaw::Twisted) {
        return unexpected(shownName(path) + ": " + flawSentence(examined.report, "the surface of the tooth") + ".");
    }
    if (remarks != nullptr) {
        std::ranges::move(remarksOn(examined.report, shownName(path)), std::back_inserter(*remarks));
    }
    auto surface = std::make_shared<Surface>();
    surface->closed = examined.report.isSolid();
    surface->base = std::make_shared<const SurfacePart>(std::move(examined.mesh));
    return std::shared_ptr<const Surface>(std::move(surface));
}

Expected<std::shared_ptr<const ToolShape>> loadTool(const std::filesystem::path& path, std::vector<Remark>* remarks) {
    Expected<TriangleMesh> mesh = loadMesh(path, remarks);
    if (!mesh) return Unexpected{mesh.error()};
    if (auto near = checkNear(*mesh, path); !near) return Unexpected{near.error()};
    return std::shared_ptr<const ToolShape>(std::make_shared<const ToolShape>(std::move(*mesh)));
}

}  // namespace tactooth
