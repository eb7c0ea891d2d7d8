// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/icons/bur_picture.h"

#include "app/gui/icons/surface_picture.h"

namespace tactooth {
namespace {

constexpr double kMargin = 0.25;  // mm below the tip
constexpr int kTriangles = 4000;  // blades and grains as one sees them in so small a picture

}  // namespace

QImage drawBur(const Bur& bur, QSize size) {
    const double scale = size.height() / (kBurPictureLength + kMargin);
    SurfacePicture picture(size, -size.width() / (2 * scale), -kMargin, scale);
    picture.add(bur.surface, [&](const Vec3& place) -> const SurfaceFinish& {  // the shank is of steel
        const bool isGrit = bur.spec.material == BurMaterial::Diamond && place.z() <= bur.spec.headLength;
        return isGrit ? kDiamondFinish : kSteelFinish;
    });
    return picture.drawn();
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
