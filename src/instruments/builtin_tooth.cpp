// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/builtin_tooth.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "instruments/anatomy/tooth_shape.h"
#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

ToothShape shapeOf(BuiltinToothKind kind) {
    switch (kind) {
        case BuiltinToothKind::lowerFirstMolar:
            return lowerFirstMolar();
        case BuiltinToothKind::upperCentralIncisor:
            return upperCentralIncisor();
        case BuiltinToothKind::upperCanine:
            break;
    }
    return upperCanine();
}

/// The root is smooth and mostly out of reach: below the neck, heights are stretched, up to this many times, so that
/// its triangles are longer and more of them are left for the crown.
constexpr double kRootStretch = 1.9;

Vec3 stretched(const Vec3& p) {
    constexpr double kNeck = -0.8, kOnset = 2.0;  // mm: where it begins, and how softly
    const double below = kNeck - p.z();
    if (below <= 0) return p;
    return {p.x(), p.y(), p.z() - (kRootStretch - 1) * below * below / (below + kOnset)};
}

TriangleMesh meshOf(const ScalarField& body, const Box3& bounds, double cellSize, int relaxations) {
    const auto field = [&](const Vec3& p) { return body(stretched(p)); };
    constexpr double kSteepest = 1.3 * kRootStretch;
    TriangleMesh mesh = isosurface(field, bounds, {cellSize, kSteepest, relaxations});
    for (Vec3f& vertex : mesh.vertices) vertex = stretched(vertex.cast<double>()).cast<float>();
    return mesh;
}

/// The cell size that gives about as many triangles: a coarse mesh measures the surface.
double cellSizeFor(const ToothShape& shape, int triangles) {
    constexpr double kTrial = 0.6;
    const TriangleMesh trial = meshOf(shape.outer, shape.bounds, kTrial, 0);
    return kTrial * std::sqrt(static_cast<double>(trial.triangles.size()) / triangles);
}

/// The tooth of the other side of the mouth.
void mirror(TriangleMesh& mesh) {
    for (Vec3f& vertex : mesh.vertices) vertex.x() = -vertex.x();
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

/// Decay in a body's frame of its own: narrow through the enamel, then spreading along the dentin's border and toward
/// the pulp, as fissure and contact lesions do.
double lesion(const ToothShape& shape, const Vec3& point, double width) {
    const Vec3 from = point - shape.lesionSite;
    const double deep = from.dot(shape.lesionInward), aside = (from - deep * shape.lesionInward).norm();
    const double mouth = taperedCapsule(Vec3(aside, 0, deep), Vec3(0, 0, -0.5), 0.22 * width,
                                        Vec3(0, 0, shape.lesionEnamel), 0.34 * width);
    const Vec3 spread(0.5 * width, 0.5 * width, 0.36 * width);
    const double body = ellipsoid(Vec3(aside, 0, deep - shape.lesionEnamel - 0.10 * width), spread);
    return smoothUnion(mouth, body, 0.15 * width);
}

}  // namespace

BuiltinTooth makeBuiltinTooth(BuiltinToothKind kind, int triangles, double lesionWidth) {
    assert(triangles > 0 && lesionWidth >= 0 && lesionWidth <= 4);
    const ToothShape shape = shapeOf(kind);
    const double cellSize = cellSizeFor(shape, triangles);
    constexpr int kRelaxations = 3;
    const auto mesh = [&](const ScalarField& body) { return meshOf(body, shape.bounds, cellSize, kRelaxations); };

    BuiltinTooth tooth;
    tooth.name = shape.name;
    tooth.fdi = shape.fdi;
    tooth.outer = mesh(shape.outer);
    // The crown's cut lies a little below the cervical line, where dentin wins: no gap at the enamel's thin edge.
    constexpr double kOverlap = 0.3;
    tooth.enamel = mesh([&](const Vec3& p) { return std::max(shape.outer(p), -shape.cervical(p) - kOverlap); });
    tooth.dentin = mesh(shape.core);

    constexpr double kCanalCell = 0.14;  // mm: the narrowest canal is 0.25 mm wide
    const double smallCell = std::min(cellSize, kCanalCell);
    const auto small = [&](const ScalarField& body) { return meshOf(body, shape.bounds, smallCell, kRelaxations); };
    tooth.pulp = small(shape.pulp);
    if (lesionWidth > 0) {
        tooth.caries = small([&](const Vec3& p) { return std::max(shape.outer(p), lesion(shape, p, lesionWidth)); });
    }
    if (mesialX(tooth.fdi) < 0) {
        for (TriangleMesh* layer : {&tooth.outer, &tooth.enamel, &tooth.dentin, &tooth.pulp, &tooth.caries}) {
            mirror(*layer);
        }
    }
    return tooth;
}

std::vector<LayerMesh> layersOf(const BuiltinTooth& tooth) {
    std::vector<LayerMesh> layers;
    const auto add = [&](MaterialId material, const TriangleMesh& mesh) {
        if (!mesh.empty()) layers.push_back({std::string(materialName(material)), material, mesh});
    };
    add(MaterialId::Enamel, tooth.enamel);
    add(MaterialId::Dentin, tooth.dentin);
    add(MaterialId::Pulp, tooth.pulp);
    add(MaterialId::Caries, tooth.caries);
    return layers;
}

}  // namespace tactooth
