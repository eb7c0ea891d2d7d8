// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/outline_overlay.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/gui/scene/mirror_outline.h"
#include "session/hands/mirror_view.h"

namespace tactooth {
namespace {

constexpr double kHandle = 4.5, kHeld = 7;  // pixels: radius of a handle
constexpr int kPad = 5;                     // pixels around the hint
constexpr double kBelowLetters = 48;        // pixels from the upper edge
constexpr int kFaint = 60;                  // of 255: what is seen from behind
const QColor kHalo(0, 0, 0, 150);

QColor inkOf(OutlineMarks::Kind kind) {
    switch (kind) {
        case OutlineMarks::Kind::Cavity:
            return {120, 235, 255};
        case OutlineMarks::Kind::Box:
            return {150, 255, 160};
        case OutlineMarks::Kind::Decay:
            return {255, 200, 90};
        case OutlineMarks::Kind::Forbidden:
            return {255, 95, 85};
    }
    return {};
}

QColor faded(QColor colour, bool isBehind) {
    if (isBehind) colour.setAlpha(kFaint);
    return colour;
}

void drawOn(QPainter& painter, const QPolygonF& polygon, OutlineMarks::Kind kind, bool isBehind) {
    const QColor ink = faded(inkOf(kind), isBehind);
    const bool isArea = kind == OutlineMarks::Kind::Forbidden && polygon.size() > 3;
    if (isArea && !isBehind) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(QBrush(ink, Qt::BDiagPattern));
        painter.drawPolygon(polygon);
    }
    painter.setBrush(Qt::NoBrush);
    for (const bool halo : {true, false}) {
        const QColor colour = halo ? faded(kHalo, isBehind) : ink;
        painter.setPen(QPen(colour, halo ? 4.5 : 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(polygon);
    }
}

}  // namespace

OutlineOverlay::OutlineOverlay(QWidget* parent) : QWidget(parent) {
    setObjectName("outlineOverlay");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void OutlineOverlay::setMarks(Layer layer, OutlineMarks marks) {
    marks_[static_cast<std::size_t>(layer)] = std::move(marks);
    setVisible(std::ranges::any_of(
        marks_, [](const OutlineMarks& each) { return !each.lines.empty() || !each.hint.isEmpty(); }));
    update();
}

void OutlineOverlay::follow(const Viewport& picture, const std::optional<MirrorDisc>& glass) {
    picture_ = picture;
    glass_ = glass;
    if (isVisible()) update();
}

std::optional<QPointF> OutlineOverlay::pointOf(const Vec3& place) const {
    const auto pixel = project(picture_.camera(), picture_.size(), place);
    return pixel ? std::optional(QPointF(pixel->x(), pixel->y()) / devicePixelRatioF()) : std::nullopt;
}

QPolygonF OutlineOverlay::polygonOf(const std::vector<Vec3>& places) const {
    QPolygonF polygon;
    for (const Vec3& place : places) {
        if (const auto at = pointOf(place)) polygon << *at;
    }
    return polygon;
}

/// The image in the mirror of what lies before the glass.
QPolygonF OutlineOverlay::imageOf(const std::vector<Vec3>& places) const {
    QPolygonF polygon;
    for (const Vec3& place : places) {
        if ((place - glass_->centre).dot(glass_->normal) <= 0) continue;
        if (const auto at = pointOf(mirrorImage(*glass_, place))) polygon << *at;
    }
    return polygon;
}

void OutlineOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPolygonF rim = glass_ ? glassInPicture(*glass_, picture_, devicePixelRatioF()) : QPolygonF();
    for (const OutlineMarks& marks : marks_) {
        for (const OutlineMarks::Line& line : marks.lines) paintLine(painter, line);
        if (!marks.hint.isEmpty()) paintHint(painter, marks.hint);
    }
    if (rim.isEmpty()) return;
    painter.setClipPath(pathOf(rim));
    for (const OutlineMarks& marks : marks_) {
        for (const OutlineMarks::Line& line : marks.lines) paintImage(painter, line);
    }
}

void OutlineOverlay::paintLine(QPainter& painter, const OutlineMarks::Line& line) const {
    const Vec3 toEye = picture_.camera().cameraInWorld.rotation * Vec3::UnitZ();
    const bool isBehind = line.outward.dot(toEye) < 0;
    const QColor ink = faded(inkOf(line.kind), isBehind);
    drawOn(painter, polygonOf(line.places), line.kind, isBehind);
    painter.setPen(QPen(kHalo, 1));
    for (std::size_t i = 0; i < line.handles.size(); ++i) {
        const auto at = pointOf(line.handles[i]);
        painter.setBrush(line.held == i ? QColor(Qt::white) : ink);
        const double radius = line.held == i ? kHeld : kHandle;
        if (at) painter.drawEllipse(*at, radius, radius);
    }
}

void OutlineOverlay::paintImage(QPainter& painter, const OutlineMarks::Line& line) const {
    const Vec3 toEye = MirrorView(picture_, *glass_).eyeAxes().col(2);
    drawOn(painter, imageOf(line.places), line.kind, line.outward.dot(toEye) < 0);
}

void OutlineOverlay::paintHint(QPainter& painter, const QString& hint) const {
    QRectF box = QRectF(fontMetrics().boundingRect(rect(), Qt::AlignHCenter | Qt::TextWordWrap, hint))
                     .adjusted(-kPad, -kPad, kPad, kPad);
    box.moveCenter(QPointF(width() / 2.0, kBelowLetters));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(12, 18, 26, 190));
    painter.drawRoundedRect(box, kPad, kPad);
    painter.setPen(QColor(245, 250, 255));
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, hint);
}

}  // namespace tactooth
