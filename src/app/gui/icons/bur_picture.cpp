// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/icons/bur_picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

namespace tactooth {
namespace {

constexpr int kSamples = 4;               // along each side of a pixel
constexpr double kMargin = 0.25;          // mm below the tip
constexpr int kTriangles = 4000;          // blades and grains as one sees them in so small a picture
const Vec3 kLight(-0.45, -0.75, 0.48);    // from the left, above and in front
const Vec3 kHalfway(-0.24, -0.94, 0.26);  // between the light and the eye

/// What the eye at -y sees of a triangle.
struct Facet {
    double depth;  // along y, mm: larger is farther
    QPolygonF corners;
    QColor colour;
};

QColor shaded(const Vec3& normal, BurMaterial material) {
    const bool isDiamond = material == BurMaterial::Diamond;
    const double diffuse = std::max(0.0, normal.dot(kLight.normalized()));
    const double gloss = std::pow(std::max(0.0, normal.dot(kHalfway.normalized())), isDiamond ? 8 : 24);
    const double light = 0.34 + 0.5 * diffuse, shine = (isDiamond ? 0.12 : 0.35) * gloss;
    const Vec3 base = isDiamond ? Vec3(0.80, 0.74, 0.62) : Vec3(0.74, 0.78, 0.83);
    const auto part = [&](double c) { return std::clamp(c * light + shine, 0.0, 1.0); };
    return QColor::fromRgbF(static_cast<float>(part(base.x())), static_cast<float>(part(base.y())),
                            static_cast<float>(part(base.z())));
}

}  // namespace

QImage drawBur(const Bur& bur, QSize size) {
    const TriangleMesh& surface = bur.surface;
    const QSize fine = kSamples * size;
    const double scale = fine.height() / (kBurPictureLength + kMargin);
    const auto onPicture = [&](const Vec3& place) {
        return QPointF(fine.width() / 2.0 + scale * place.x(), fine.height() - scale * (place.z() + kMargin));
    };
    std::vector<Facet> facets;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        const Vec3 normal = surface.areaVector(i).normalized();
        if (!(normal.y() < 0)) continue;
        const bool isHead =
            (surface.corner(i, 0) + surface.corner(i, 1) + surface.corner(i, 2)).z() / 3 <= bur.spec.headLength;
        Facet facet{0, {}, shaded(normal, isHead ? bur.spec.material : BurMaterial::Carbide)};  // the shank is of steel
        for (int k = 0; k < 3; ++k) {
            const Vec3 corner = surface.corner(i, k);
            facet.depth += corner.y() / 3;
            facet.corners << onPicture(corner);
        }
        facets.push_back(std::move(facet));
    }
    std::stable_sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) { return a.depth > b.depth; });
    QImage picture(fine, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    for (const Facet& facet : facets) {
        painter.setPen(facet.colour);  // closes the seams between neighbours
        painter.setBrush(facet.colour);
        painter.drawPolygon(facet.corners);
    }
    painter.end();
    return picture.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

void BurPictures::setSize(QSize size, double ratio) {
    if (size == size_ && ratio == ratio_) return;
    size_ = size;
    ratio_ = ratio;
    drawn_.clear();
}

const QPixmap* BurPictures::find(const std::string& number) const {
    const auto found = drawn_.find(number);
    return found == drawn_.end() ? nullptr : &found->second;
}

void BurPictures::draw(const BurSpec& spec) {
    QPixmap picture = QPixmap::fromImage(drawBur(makeBur(spec, kTriangles), (ratio_ * QSizeF(size_)).toSize()));
    picture.setDevicePixelRatio(ratio_);
    drawn_.insert_or_assign(spec.number, std::move(picture));
}

}  // namespace tactooth
