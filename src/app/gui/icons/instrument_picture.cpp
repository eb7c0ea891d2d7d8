// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/icons/instrument_picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/gui/icons/surface_picture.h"
#include "instruments/bur_shape.h"
#include "instruments/handpiece_kind.h"

namespace tactooth {
namespace {

constexpr double kMargin = 0.04;  // of the picture, around
const SurfaceFinish kBlack{Vec3(0.10, 0.11, 0.13), 0.2, 16};
const QColor kRed(220, 20, 30, 210), kBlue(20, 80, 230, 210);

/// What a picture shows, mm.
struct Shown {
    double left, bottom, width;
};

SurfacePicture pictureOf(const Shown& window, QSize size) {
    const double wide = window.width * (1 + 2 * kMargin);
    return {size, window.left - kMargin * window.width, window.bottom - kMargin * window.width, size.width() / wide};
}

Shown windowOf(HandInstrument kind) {
    switch (kind) {
        case HandInstrument::Explorer:
            return {-2.8, 0, 9};
        case HandInstrument::Probe:
            return {-5.2, 0, 11.5};
        case HandInstrument::Excavator:
            break;
    }
    return {-2.5, 0, 6};
}

bool isOnMark(const Vec3& place) {
    constexpr double kHalf = 0.3;  // mm: wider than the rings of the surface, so that a small picture shows them
    return std::ranges::any_of(kProbeMarks, [&](double mark) { return std::abs(place.z() - mark) < kHalf; });
}

/// A band around the neck of a contra-angle, square to it.
void addRing(QImage& image, const Shown& shown, const QColor& colour) {
    constexpr double kFrom = 12, kWide = 2, kSlope = 0.36;  // mm along the neck; its slope
    constexpr double kLow = 12, kHigh = 26;                 // mm: below and above the neck
    const double scale = image.width() / (shown.width * (1 + 2 * kMargin));
    const auto at = [&](double x, double z) {
        return QPointF(scale * (x - shown.left + kMargin * shown.width),
                       image.height() - scale * (z - shown.bottom + kMargin * shown.width));
    };
    const double lean = kSlope * (kHigh - kLow);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setCompositionMode(QPainter::CompositionMode_SourceAtop);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{at(kFrom + lean / 2, kLow), at(kFrom + kWide + lean / 2, kLow),
                                  at(kFrom + kWide - lean / 2, kHigh), at(kFrom - lean / 2, kHigh)});
}

}  // namespace

QImage drawHandInstrument(HandInstrument kind, QSize size) {
    SurfacePicture picture = pictureOf(windowOf(kind), size);
    picture.add(heldInstrument(kind), [&](const Vec3& place) -> const SurfaceFinish& {
        return kind == HandInstrument::Probe && isOnMark(place) ? kBlack : kSteelFinish;
    });
    return picture.drawn();
}

QImage drawHandpiece(const SpindlePreset& drive, const TriangleMesh& handpiece, QSize size) {
    constexpr int kTriangles = 1500;  // of the bur
    const bool isTurbine = handpieceOf(drive) == HandpieceKind::Turbine;
    const Shown shown{-7, 0, 27};
    SurfacePicture picture = pictureOf(shown, size);
    const auto steel = [](const Vec3&) -> const SurfaceFinish& { return kSteelFinish; };
    picture.add(makeBur(*findBur("4"), kTriangles).surface, steel);
    picture.add(handpiece, steel);
    QImage image = picture.drawn();
    if (!isTurbine) addRing(image, shown, drive.pedalCurve == PedalCurve::Electric ? kRed : kBlue);
    return image;
}

}  // namespace tactooth
