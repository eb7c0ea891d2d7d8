// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/measure_overlay.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tactooth {
namespace {

constexpr int kPad = 5, kMargin = 4;   // pixels around a text, and between it and the edge
constexpr double kDot = 3.5;           // pixels: radius of a place
constexpr double kCross = 7;           // pixels: half of the cross under the mouse
constexpr double kNormalLength = 1.5;  // mm
constexpr double kWallLength = 1;      // mm, up and down the wall
constexpr double kUndercut = 0.05;     // degrees: less is written as 0.0
constexpr double kLevel = 0.1;         // sine: a floor rises nowhere
constexpr int kDiscCorners = 32;
const QColor kInk(120, 235, 255), kHalo(0, 0, 0, 150);

/// The disc over which the normal is averaged.
std::vector<Vec3> discOf(const MeasuredPlace& place) {
    const Vec3 u = place.normal.unitOrthogonal(), v = place.normal.cross(u);
    std::vector<Vec3> corners;
    for (int i = 0; i <= kDiscCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kDiscCorners;
        corners.emplace_back(place.point + kNormalDisc * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return corners;
}

/// Else an angle between directions at the places.
bool isLength(MeasureKind kind) { return kind == MeasureKind::Distance || kind == MeasureKind::RemainingDentin; }

/// What shows how the surface lies at a place: the normal, or how the wall rises.
std::vector<std::vector<Vec3>> linesAt(const MeasuredPlace& place, const SurfaceMeasure& measure) {
    if (isLength(measure.kind())) return {};
    if (measure.kind() == MeasureKind::Angle)
        return {discOf(place), {place.point, place.point + kNormalLength * place.normal}};
    const Vec3 up = measure.axis() - measure.axis().dot(place.normal) * place.normal;
    if (up.norm() < kLevel) return {discOf(place)};
    const Vec3 rise = kWallLength * up.normalized();
    return {discOf(place), {place.point - rise, place.point + rise}};
}

}  // namespace

MeasureOverlay::MeasureOverlay(QWidget* parent) : QWidget(parent) {
    setObjectName("measureOverlay");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void MeasureOverlay::show(const SurfaceMeasure& measure, const std::optional<Vec3>& pointer, const Viewport& picture) {
    const double ratio = devicePixelRatioF();
    const auto onWidget = [&](const Vec3& place) -> std::optional<QPointF> {
        const auto pixel = project(picture.camera(), picture.size(), place);
        return pixel ? std::optional(QPointF(pixel->x(), pixel->y()) / ratio) : std::nullopt;
    };
    const auto lineThrough = [&](const std::vector<Vec3>& places) {
        QPolygonF line;
        for (const Vec3& place : places) {
            if (const auto at = onWidget(place)) line << *at;
        }
        return line;
    };
    Mark mark;
    for (const MeasuredPlace& place : measure.places()) {
        if (const auto at = onWidget(place.point)) mark.places.push_back(*at);
        for (const std::vector<Vec3>& line : linesAt(place, measure)) mark.lines.push_back(lineThrough(line));
    }
    if (const auto result = measure.result()) {
        if (isLength(measure.kind())) {
            mark.lines.push_back(lineThrough({measure.places()[0].point, measure.places()[1].point}));
        }
        mark.result = resultText(measure, *result);
    }
    if (pointer) mark.pointer = onWidget(*pointer);
    mark.hint = whatText(measure.kind()) + '\n' + nextText(measure);
    mark_ = std::move(mark);
    QWidget::show();
    update();
}

QString MeasureOverlay::resultText(const SurfaceMeasure& measure, double result) {
    if (isLength(measure.kind())) return tr("%1 mm").arg(result, 0, 'f', 2);
    const QString angle = tr("%1°").arg(result, 0, 'f', 1);
    const auto leans = measure.leans();
    if (!leans) return angle;
    const QString sum = tr("%1 (%2°, %3°)").arg(angle).arg((*leans)[0], 0, 'f', 1).arg((*leans)[1], 0, 'f', 1);
    return std::ranges::min(*leans) < -kUndercut ? tr("%1, undercut").arg(sum) : sum;
}

QString MeasureOverlay::whatText(MeasureKind kind) {
    switch (kind) {
        case MeasureKind::Distance:
            return tr("Distance from place to place");
        case MeasureKind::Angle:
            return tr("Angle between walls: normals over discs of %1 mm radius").arg(kNormalDisc);
        case MeasureKind::Taper:
            return tr("Taper: how far two opposite walls lean from the direction of insertion");
        case MeasureKind::RemainingDentin:
            return tr("Remaining dentin: straight to the pulp");
    }
    return {};
}

QString MeasureOverlay::nextText(const SurfaceMeasure& measure) {
    const bool isPulp = measure.kind() == MeasureKind::RemainingDentin, hasResult = measure.result().has_value();
    if (isPulp && !measure.places().empty() && !hasResult) return tr("This tooth has no pulp. Esc: clear");
    if (measure.places().size() == 2 && !hasResult) {
        return tr("These are not two opposite walls. Click again. Esc: clear");
    }
    if (hasResult) return tr("Click to measure again. Esc: clear");
    if (isPulp) return tr("Click a place. Esc: end");
    return measure.places().empty() ? tr("Click the first place. Esc: end") : tr("Click the second place. Esc: clear");
}

void MeasureOverlay::showNothing() {
    mark_ = {};
    hide();
}

/// Inside the widget.
QRectF MeasureOverlay::boxFor(const QString& text, const QFont& font, const QPointF& middle) const {
    QRectF box = QRectF(QFontMetrics(font).boundingRect(QRect(0, 0, width(), height()), Qt::AlignLeft, text))
                     .adjusted(-kPad, -kPad, kPad, kPad);
    box.moveCenter(middle);
    box.moveLeft(std::clamp(box.left(), double{kMargin}, std::max<double>(kMargin, width() - box.width() - kMargin)));
    box.moveTop(std::clamp(box.top(), double{kMargin}, std::max<double>(kMargin, height() - box.height() - kMargin)));
    return box;
}

void MeasureOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const bool halo : {true, false}) {
        painter.setPen(QPen(halo ? kHalo : kInk, halo ? 4.5 : 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        for (const QPolygonF& line : mark_.lines) painter.drawPolyline(line);
        if (mark_.pointer) {
            painter.drawLine(*mark_.pointer - QPointF(kCross, 0), *mark_.pointer + QPointF(kCross, 0));
            painter.drawLine(*mark_.pointer - QPointF(0, kCross), *mark_.pointer + QPointF(0, kCross));
        }
        painter.setPen(QPen(kHalo, 1));
        painter.setBrush(halo ? kHalo : kInk);
        for (const QPointF& place : mark_.places) painter.drawEllipse(place, kDot, kDot);
    }
    const auto write = [&](const QString& text, const QPointF& middle, const QColor& ink) {
        const QRectF box = boxFor(text, painter.font(), middle);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(12, 18, 26, 190));
        painter.drawRoundedRect(box, kPad, kPad);
        painter.setPen(ink);
        painter.drawText(box, Qt::AlignCenter, text);
    };
    constexpr double kBelowLetters = 48;  // pixels from the upper edge
    write(mark_.hint, QPointF(width() / 2.0, kBelowLetters), QColor(245, 250, 255));
    if (mark_.result.isEmpty() || mark_.places.size() < 2) return;
    QFont large = font();
    large.setBold(true);
    painter.setFont(large);
    const double aside = 1.6 * fontMetrics().height();
    write(mark_.result, (mark_.places[0] + mark_.places[1]) / 2 - QPointF(0, aside), kInk);
}

}  // namespace tactooth
