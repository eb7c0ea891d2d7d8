// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/merged_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "collision/bvh/closest_point.h"
#include "geometry/field/isosurface.h"
#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/mesh_repair.h"
#include "geometry/mesh/mesh_report.h"
#include "geometry/mesh/near_weld.h"
#include "patient/messages.h"

namespace tactooth {
namespace {

constexpr std::array<double, 6> kTolerances = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05};  // mm
constexpr double kNewTriangles = 0.2;                                                   // mm
constexpr double kGap = 0.05;  // mm: layers this far apart are one body when they are joined by distance

/// Removes faces that two layers have in common: triangles with the same three corners.
void dropCommonFaces(TriangleMesh& mesh) {
    std::map<Triangle, int> uses;
    const auto sorted = [](Triangle triangle) {
        std::ranges::sort(triangle);
        return triangle;
    };
    for (const Triangle& triangle : mesh.triangles) ++uses[sorted(triangle)];
    std::erase_if(mesh.triangles,
                  [&](const Triangle& triangle) { return isDegenerate(triangle) || uses[sorted(triangle)] > 1; });
}

double volumeOf(const std::vector<LayerMesh>& layers) {
    double volume = 0;
    for (const LayerMesh& layer : layers) volume += std::abs(reportOn(layer.mesh).signedVolume);
    return volume;
}

/// The outer shell after welding, if it is a surface with the volume of all layers together.
std::optional<TriangleMesh> welded(const TriangleMesh& all, double tolerance, double volume) {
    TriangleMesh mesh = weldedWithin(all, tolerance);
    dropCommonFaces(mesh);
    if (mesh.empty()) return std::nullopt;
    TriangleMesh outer = connectedComponents(mesh).front();
    const MeshReport report = reportOn(outer);
    // The common faces are gone, so the shell encloses all layers: 1 % allows for small components between them.
    if (!report.watertight() || std::abs(report.signedVolume - volume) > 0.01 * volume) return std::nullopt;
    return outer;
}

TriangleMesh mergedByDistance(const std::vector<LayerMesh>& layers) {
    std::vector<SurfacePart> parts;
    Box3 box;
    for (const LayerMesh& layer : layers) {
        parts.emplace_back(layer.mesh);
        box.extend(boundingBox(layer.mesh));
    }
    const ScalarField field = [&](const Vec3& point) {
        double nearest = signedDistance(parts.front(), point);
        for (std::size_t i = 1; i < parts.size(); ++i) nearest = std::min(nearest, signedDistance(parts[i], point));
        return nearest - kGap / 2;
    };
    const Box3 around(box.min().array() - 1, box.max().array() + 1);
    const TriangleMesh all = isosurface(field, around, {.cellSize = kNewTriangles});
    return all.empty() ? all : connectedComponents(all).front();
}

}  // namespace

Expected<MergedLayers> mergeLayers(const std::vector<LayerMesh>& layers) {
    if (layers.size() == 1) {
        return MergedLayers{layers.front().mesh, {ImportNoteTopic::Layers, msg::kNoteOneLayer}};
    }
    TriangleMesh all;
    for (const LayerMesh& layer : layers) append(all, layer.mesh);
    const double volume = volumeOf(layers);
    for (const double tolerance : kTolerances) {
        if (auto outer = welded(all, tolerance, volume)) {
            return MergedLayers{std::move(*outer),
                                {ImportNoteTopic::Layers, {msg::kNoteLayersWelded, rounded(tolerance, 3)}}};
        }
    }
    TriangleMesh outer = mergedByDistance(layers);
    if (!reportOn(outer).watertight()) {
        return unexpected(msg::kLayersNotClosed);
    }
    return MergedLayers{
        std::move(outer),
        {ImportNoteTopic::Layers, {msg::kNoteLayersMerged, rounded(kTolerances.back(), 2), rounded(kNewTriangles, 1)}}};
}

}  // namespace tactooth
