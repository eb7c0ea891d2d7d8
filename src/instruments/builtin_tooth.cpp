// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/builtin_tooth.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "instruments/anatomy/blend.h"
#include "instruments/anatomy/tooth_shape.h"

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

/// The cell size that gives about as many triangles: a coarse mesh measures the surface.
double cellSizeFor(const ToothShape& shape, int triangles) {
    constexpr double kTrial = 0.8;
    const TriangleMesh trial = isosurface(shape.outer, shape.bounds, {.cellSize = kTrial, .relaxations = 0});
    return kTrial * std::sqrt(static_cast<double>(trial.triangles.size()) / triangles);
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
    const IsosurfaceOptions fineness{.cellSize = cellSizeFor(shape, triangles)};
    const auto mesh = [&](const ScalarField& field) { return isosurface(field, shape.bounds, fineness); };

    BuiltinTooth tooth;
    tooth.name = shape.name;
    tooth.fdi = shape.fdi;
    tooth.outer = mesh(shape.outer);
    // The crown's cut lies a little below the cervical line, where dentin wins: no gap at the enamel's thin edge.
    constexpr double kOverlap = 0.3;
    tooth.enamel = mesh([&](const Vec3& p) { return std::max(shape.outer(p), -shape.cervical(p) - kOverlap); });
    tooth.dentin = mesh(shape.core);

    constexpr double kCanalCell = 0.14;  // mm: the narrowest canal is 0.25 mm wide
    const double smallCell = std::min(fineness.cellSize, kCanalCell);
    const auto small = [&](const ScalarField& field) {
        return isosurface(field, shape.bounds, {.cellSize = smallCell});
    };
    tooth.pulp = small(shape.pulp);
    if (lesionWidth > 0) {
        tooth.caries = small([&](const Vec3& p) { return std::max(shape.outer(p), lesion(shape, p, lesionWidth)); });
    }
    return tooth;
}

}  // namespace tactooth
