// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/outline_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <limits>

#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kReach = 11;  // pixels: a point that is so near is meant

bool removes(const QKeySequence& keys) {
    return keys == QKeySequence(Qt::Key_Delete) || keys == QKeySequence(Qt::Key_Backspace);
}
bool undoes(const QKeySequence& keys) { return keys == QKeySequence(Qt::CTRL | Qt::Key_Z); }
bool redoes(const QKeySequence& keys) {
    return keys == QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z) || keys == QKeySequence(Qt::CTRL | Qt::Key_Y);
}

/// The place of the tooth itself under a pixel, with the direction out of it; nothing beside the tooth.
std::optional<SurfaceHit> hitUnder(const Surface& surface, const Ray& ray) {
    const auto hit = firstSeen(surface, ray);
    return hit && !hit->isAdjacent ? hit : std::nullopt;
}

/// From a place of the tooth to a pixel; infinite behind the eye.
double pixelsTo(const Viewport& picture, const Vec3& place, const Vec2& pixel) {
    const auto at = project(picture.camera(), picture.size(), place);
    return at ? (Vec2(at->x(), at->y()) - pixel).norm() : std::numeric_limits<double>::infinity();
}

}  // namespace

void OutlineTool::setDraft(ExerciseDraft* draft) {
    if (draft == draft_) return;
    draft_ = draft;
    held_.reset();
    drags_ = false;
    paints_ = false;
    zone_ = 0;
    stroke_ = DraftStroke::Outline;
}

std::optional<int> OutlineTool::zone() const {
    const auto count = draft_ != nullptr ? static_cast<int>(draft_->exercise().forbidden.size()) : 0;
    if (count == 0) return std::nullopt;
    return std::min(zone_, count - 1);
}

std::optional<DraftPoint> OutlineTool::pointAt(const Viewport& picture, const Vec2& pixel) const {
    std::optional<DraftPoint> nearest;
    double least = kReach;
    if (draft_ == nullptr || stroke_ == DraftStroke::Decay) return nearest;
    for (const DraftLine& line : draft_->lines()) {
        for (std::size_t i = 0; i < draft_->points(line).size(); ++i) {
            const double distance = pixelsTo(picture, draft_->points(line)[i], pixel);
            if (distance >= least) continue;
            least = distance;
            nearest = DraftPoint{line, i};
        }
    }
    return nearest;
}

void OutlineTool::hold(const std::optional<DraftPoint>& point) {
    if (held_ == point) return;
    held_ = point;
    if (point && !point->line.isCavity()) zone_ = point->line.zone;
    emit changed();
}

void OutlineTool::press(const Surface& surface, const Viewport& picture, const Vec2& pixel) {
    if (draft_ == nullptr) return;
    if (const auto point = pointAt(picture, pixel)) {
        if (point->point == 0 && draft_->openLine() == point->line && draft_->points(point->line).size() > 2) {
            draft_->closeLine();
            emit changed();
        }
        drags_ = true;
        ++drag_;
        return hold(point);
    }
    paints_ = stroke_ == DraftStroke::Decay;  // a stroke may begin beside the tooth
    if (paints_) ++drag_;
    const Ray ray = picture.rayThrough(pixel);
    if (const auto hit = hitUnder(surface, ray)) add(ray.origin + hit->distance * ray.direction, hit->normal);
}

void OutlineTool::add(const Vec3& place, const Vec3& normal) {
    if (paints_) return paint(place);
    DraftLine line;
    if (stroke_ == DraftStroke::Zone) line = zone() ? DraftLine{*zone()} : draft_->beginZone();
    const std::size_t point = draft_->addPoint(line, place, sideOf(draft_->exercise(), normal));
    drags_ = true;
    ++drag_;
    held_ = DraftPoint{line, point};
    emit changed();
}

void OutlineTool::paint(const Vec3& place) {
    draft_->addDecay(place, "paint " + std::to_string(drag_));
    emit changed();
}

void OutlineTool::release() {
    if (!isInStroke()) return;
    drags_ = paints_ = false;
    if (draft_ != nullptr) draft_->endStep();
    emit changed();
}

void OutlineTool::move(const Surface& surface, const Viewport& picture, const Vec2& pixel) {
    if (draft_ == nullptr) return;
    if (paints_) {
        const Ray ray = picture.rayThrough(pixel);
        if (const auto hit = hitUnder(surface, ray)) paint(ray.origin + hit->distance * ray.direction);
        return;
    }
    if (!drags_ || !held_) return hold(pointAt(picture, pixel));
    const auto at = project(picture.camera(), picture.size(), draft_->points(held_->line)[held_->point]);
    constexpr double kStill = 3;  // pixels: a click that trembles moves nothing
    const std::string step = "drag " + std::to_string(drag_);
    const Ray ray = picture.rayThrough(pixel);
    const auto hit = hitUnder(surface, ray);
    if (!hit || (at && (Vec2(at->x(), at->y()) - pixel).norm() < kStill)) return;
    draft_->movePoint(held_->line, held_->point, ray.origin + hit->distance * ray.direction, step);
    emit changed();
}

void OutlineTool::clickRight(const Viewport& picture, const Vec2& pixel) {
    if (draft_ != nullptr && stroke_ == DraftStroke::Decay) {
        const std::vector<Vec3> places = draft_->decay();
        const auto nearest =
            std::ranges::min_element(places, {}, [&](const Vec3& place) { return pixelsTo(picture, place, pixel); });
        if (nearest == places.end() || pixelsTo(picture, *nearest, pixel) >= kReach) return;
        draft_->removeDecay(static_cast<std::size_t>(nearest - places.begin()));
        return emit changed();
    }
    if (const auto point = pointAt(picture, pixel)) remove(*point);
}

void OutlineTool::remove(const DraftPoint& point) {
    held_.reset();
    drags_ = false;
    draft_->removePoint(point.line, point.point);
    emit changed();
}

bool OutlineTool::wants(const QKeySequence& keys) const {
    return draft_ != nullptr && (removes(keys) || undoes(keys) || redoes(keys));
}

void OutlineTool::obey(const QKeySequence& keys) {
    if (removes(keys)) {
        if (held_) remove(*held_);
        return;
    }
    held_.reset();
    drags_ = paints_ = false;
    undoes(keys) ? draft_->undo() : draft_->redo();
    emit changed();
}

}  // namespace tactooth
