// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/icons/surface_picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tactooth {
namespace {

constexpr int kSamples = 4;               // along each side of a pixel
const Vec3 kLight(-0.45, -0.75, 0.48);    // from the left, above and in front
const Vec3 kHalfway(-0.24, -0.94, 0.26);  // between the light and the eye

QColor shaded(const Vec3& normal, const SurfaceFinish& finish) {
    const double diffuse = std::max(0.0, normal.dot(kLight.normalized()));
    const double gloss = std::pow(std::max(0.0, normal.dot(kHalfway.normalized())), finish.sharpness);
    const double light = 0.34 + 0.5 * diffuse, shine = finish.shine * gloss;
    const auto part = [&](double c) { return static_cast<float>(std::clamp(c * light + shine, 0.0, 1.0)); };
    return QColor::fromRgbF(part(finish.colour.x()), part(finish.colour.y()), part(finish.colour.z()));
}

}  // namespace

SurfacePicture::SurfacePicture(QSize size, double left, double bottom, double scale)
    : size_(size), left_(left), bottom_(bottom), scale_(kSamples * scale) {}

void SurfacePicture::add(const TriangleMesh& surface,
                         const std::function<const SurfaceFinish&(const Vec3&)>& finishAt) {
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        const Vec3 normal = surface.areaVector(i).normalized();
        if (!(normal.y() < 0)) continue;
        const Vec3 middle = (surface.corner(i, 0) + surface.corner(i, 1) + surface.corner(i, 2)) / 3;
        Facet facet{middle.y(), {}, shaded(normal, finishAt(middle))};
        for (int k = 0; k < 3; ++k) {
            const Vec3 corner = surface.corner(i, k);
            facet.corners << QPointF(scale_ * (corner.x() - left_),
                                     kSamples * size_.height() - scale_ * (corner.z() - bottom_));
        }
        facets_.push_back(std::move(facet));
    }
}

QImage SurfacePicture::drawn() {
    std::stable_sort(facets_.begin(), facets_.end(), [](const Facet& a, const Facet& b) { return a.depth > b.depth; });
    QImage picture(kSamples * size_, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    for (const Facet& facet : facets_) {
        painter.setPen(facet.colour);  // closes the seams between neighbours
        painter.setBrush(facet.colour);
        painter.drawPolygon(facet.corners);
    }
    painter.end();
    return picture.scaled(size_, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace tactooth
