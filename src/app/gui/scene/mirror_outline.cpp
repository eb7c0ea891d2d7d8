// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/mirror_outline.h"

#include <cmath>
#include <numbers>

namespace tactooth {

QPolygonF glassInPicture(const MirrorDisc& glass, const Viewport& picture, double pixelRatio) {
    constexpr int kCorners = 96;
    if ((picture.camera().cameraInWorld.position - glass.centre).dot(glass.normal) <= 0) return {};
    const Vec3 u = glass.normal.unitOrthogonal();
    const Vec3 v = glass.normal.cross(u);
    QPolygonF rim;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        const Vec3 place = glass.centre + glass.radius * (std::cos(angle) * u + std::sin(angle) * v);
        const auto pixel = project(picture.camera(), picture.size(), place);
        if (!pixel) return {};
        rim << QPointF(pixel->x(), pixel->y()) / pixelRatio;
    }
    return rim;
}

QPainterPath pathOf(const QPolygonF& polygon) {
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

}  // namespace tactooth
