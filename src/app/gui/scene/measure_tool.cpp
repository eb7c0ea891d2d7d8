// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/measure_tool.h"

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"
#include "session/control/surface_ray.h"

namespace tactooth {

MeasureTool::MeasureTool(QWidget& view) : QObject(&view), view_(view), overlay_(new MeasureOverlay(&view)) {}

void MeasureTool::setKind(std::optional<MeasureKind> kind) {
    if (!allowed_) kind.reset();
    measure_ = kind ? std::optional(SurfaceMeasure(*kind, axis_)) : std::nullopt;
    pointer_.reset();
    showChange();
}

std::optional<MeasureKind> MeasureTool::kind() const {
    return measure_ ? std::optional(measure_->kind()) : std::nullopt;
}

void MeasureTool::setAllowed(bool allowed) {
    allowed_ = allowed;
    if (!allowed) return setKind({});
    emit changed();
}

void MeasureTool::clear() {
    if (!measure_) return;
    if (measure_->places().empty()) return setKind({});
    measure_->clear();
    showChange();
}

void MeasureTool::takeTooth() { setAxis(Vec3::UnitZ()); }

void MeasureTool::setAxis(const Vec3& axis) {
    TACTOOTH_ASSERT(isUnit(axis));
    axis_ = axis;
    if (measure_) measure_.emplace(measure_->kind(), axis_);
    showChange();
}

void MeasureTool::showChange() {
    show();
    emit changed();
}

void MeasureTool::point(const Surface& surface, const Viewport& picture, const Vec2& pixel) {
    point(surface, picture, picture.rayThrough(pixel));
}

void MeasureTool::point(const Surface& surface, const Viewport& picture, const Ray& ray) {
    const auto seen = firstSeen(surface, ray);
    pointer_ = seen ? std::optional<Vec3>(ray.origin + seen->distance * ray.direction) : std::nullopt;
    follow(picture);
}

void MeasureTool::pick(const Surface& surface, const LayeredTooth& tooth, const Viewport& picture, const Vec2& pixel) {
    pick(surface, tooth, picture, picture.rayThrough(pixel));
}

void MeasureTool::pick(const Surface& surface, const LayeredTooth& tooth, const Viewport& picture, const Ray& ray) {
    if (!measure_) return;
    const auto place = placeOn(surface, ray);
    if (!place) return;
    const bool goesToPulp = measure_->kind() == MeasureKind::RemainingDentin;
    measure_->add(*place, goesToPulp ? nearestPulp(tooth, place->point) : std::nullopt);
    pointer_.reset();
    follow(picture);
    emit changed();
}

void MeasureTool::follow(const Viewport& picture) {
    picture_ = picture;
    show();
}

void MeasureTool::show() {
    if (!measure_) return overlay_->showNothing();
    overlay_->setGeometry(view_.rect());
    overlay_->show(*measure_, pointer_, picture_);
}

}  // namespace tactooth
