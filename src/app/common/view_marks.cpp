// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/view_marks.h"

#include <QImage>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/common/images/image_view.h"
#include "app/common/offscreen_application.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

const QColor kGround(20, 26, 32, 150);
const QColor kInk(245, 248, 250);

QFont withPixels(QFont font, double pixels) {
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(pixels))));
    return font;
}

}  // namespace

ScaleBar scaleBar(double pixelsPerMm, double widest) {
    TACTOOTH_ASSERT(pixelsPerMm > 0 && widest > 0);
    const double most = widest / pixelsPerMm;
    const double decade = std::pow(10, std::floor(std::log10(most)));
    double length = decade;
    for (const double step : {2.0, 5.0}) {
        if (step * decade <= most) length = step * decade;
    }
    return {length, length * pixelsPerMm};
}

std::array<AxisLetter, kAxisLetters> axisLetters(const Camera& camera, ImageSize size, double mesialX, double margin) {
    constexpr double kShortest = 0.3;  // of an axis in the picture: shorter ones point at the eye or away from it
    const Vec3 mesial = mesialX * Vec3::UnitX();
    const std::array<Vec3, kAxisLetters> axes = {Vec3::UnitY(), -Vec3::UnitY(), mesial,
                                                 -mesial,       Vec3::UnitZ(),  -Vec3::UnitZ()};
    const Quat toCamera = camera.cameraInWorld.rotation.conjugate();
    const Vec2 middle(size.width / 2.0, size.height / 2.0);
    const Vec2 reach = (middle.array() - margin).max(1);
    std::array<AxisLetter, kAxisLetters> letters;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const Vec3 seen = toCamera * axes[i];
        const Vec2 inPicture(seen.x(), -seen.y());
        letters[i].letter = kAxisLetterNames[i];
        letters[i].visible = inPicture.norm() > kShortest;
        if (!letters[i].visible) continue;
        // Where the axis through the middle meets the edge.
        const double beyond = (inPicture.cwiseAbs().array() / reach.array()).maxCoeff();
        letters[i].place = middle + inPicture / beyond;
    }
    return letters;
}

void drawScaleBar(QPainter& painter, const QRectF& box, const ScaleBar& bar) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kGround);
    const double unit = box.height() / 4;
    painter.drawRoundedRect(box, unit, unit);
    const double left = box.center().x() - bar.pixels / 2, right = left + bar.pixels, low = box.bottom() - unit;
    painter.setPen(QPen(kInk, std::max(1.0, unit / 4)));
    painter.drawLine(QPointF(left, low), QPointF(right, low));
    for (const double x : {left, right}) painter.drawLine(QPointF(x, low - unit / 2), QPointF(x, low + unit / 2));
    painter.setFont(withPixels(painter.font(), 1.7 * unit));
    painter.drawText(QRectF(box.x(), box.y(), box.width(), 2.5 * unit), Qt::AlignCenter,
                     QLocale().toString(bar.millimetres, 'g', 3) + " mm");
}

void drawAxisLetter(QPainter& painter, const QRectF& box, char letter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kGround);
    painter.drawEllipse(box);
    painter.setPen(kInk);
    painter.setFont(withPixels(painter.font(), 0.62 * box.height()));
    painter.drawText(box, Qt::AlignCenter, QString(QLatin1Char(letter)));
}

void drawViewMarks(Image& image, const Camera& camera, double mesialX, double pixelsPerMm) {
    const OffscreenApplication application;
    QImage canvas = viewOf(image);
    QPainter painter(&canvas);
    const double unit = std::max(4.0, image.size.height / 100.0);
    const ScaleBar bar = scaleBar(pixelsPerMm, image.size.width / 5.0);
    const double width = bar.pixels + 4 * unit;
    drawScaleBar(painter, QRectF((image.size.width - width) / 2, image.size.height - 9 * unit, width, 4 * unit), bar);
    for (const AxisLetter& letter : axisLetters(camera, image.size, mesialX, 2.5 * unit)) {
        if (!letter.visible) continue;
        drawAxisLetter(painter,
                       QRectF(letter.place.x() - 1.6 * unit, letter.place.y() - 1.6 * unit, 3.2 * unit, 3.2 * unit),
                       letter.letter);
    }
}

}  // namespace tactooth
