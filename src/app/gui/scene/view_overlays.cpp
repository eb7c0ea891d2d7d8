// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/view_overlays.h"

#include <QPainter>
#include <QWidget>
#include <cmath>
#include <functional>
#include <utility>

#include "app/common/legends/distance_legend.h"
#include "app/common/legends/ghost_legend.h"
#include "app/gui/scene/corner_geometry.h"
#include "app/gui/scene/view_cube.h"
#include "view/camera/magnifier.h"

namespace tactooth {
namespace {

constexpr int kMargin = 10;  // pixels of the screen between the marks and the edge
constexpr int kGap = 4;      // pixels of the screen between two marks
constexpr int kLetter = 24;  // pixels: diameter of the disc of a letter
constexpr int kBarHeight = 30;
constexpr double kWidestBar = 170;  // pixels

}  // namespace

/// A mark that the mouse does not notice.
class ViewOverlays::Mark final : public QWidget {
public:
    using Paint = std::function<void(QPainter&, const QRectF&)>;

    Mark(QWidget* parent, const char* name, Paint paint) : QWidget(parent), paint_(std::move(paint)) {
        setObjectName(name);
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
        hide();
    }
    void setPaint(Paint paint) {
        paint_ = std::move(paint);
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        paint_(painter, rect());
    }

private:
    Paint paint_;
};

ViewOverlays::ViewOverlays(QWidget& view) : QObject(&view), view_(view) {
    scaleBar_ = new Mark(&view, "scaleBarMark", [](QPainter&, const QRectF&) {});
    for (std::size_t i = 0; i < kAxisLetters; ++i) {
        letters_[i] =
            new Mark(&view, "axisLetterMark", [letter = kAxisLetterNames[i]](QPainter& painter, const QRectF& box) {
                drawAxisLetter(painter, box, letter);
            });
        letters_[i]->resize(kLetter, kLetter);
    }
    magnifier_ = new Mark(&view, "magnifierFrame", [](QPainter& painter, const QRectF& box) {
        painter.setPen(QColor(235, 240, 245, 200));
        painter.drawRect(box.adjusted(0, 0, -1, -1));
        painter.drawText(box.adjusted(6, 4, -6, -4), Qt::AlignLeft | Qt::AlignTop,
                         QStringLiteral("\u00d7%1").arg(kMagnification));
    });
    legend_ = new Mark(&view, "colourLegend", [](QPainter&, const QRectF&) {});
    cube_ = new ViewCube(&view);
    cube_->hide();
}

void ViewOverlays::choose(const ViewAids& aids, bool magnifies) {
    aids_ = aids;
    scaleBar_->setVisible(aids.scaleBar);
    cube_->setVisible(aids.cube);
    magnifier_->setVisible(aids.magnifier && magnifies);
    for (Mark* letter : letters_) {
        if (!aids.letters) letter->hide();
    }
}

void ViewOverlays::showLegend(const std::optional<DistanceScale>& scale, bool hasGhost) {
    legend_->setVisible(scale || hasGhost);
    const QString stillToCut = tr("still to cut");
    if (scale) {
        const DistanceLegendWords words{tr("cut too deep"), stillToCut, tr("within")};
        legend_->setPaint([scale = *scale, words](QPainter& painter, const QRectF& box) {
            drawDistanceLegend(painter, box, scale, words);
        });
    } else if (hasGhost) {
        legend_->setPaint(
            [stillToCut](QPainter& painter, const QRectF& box) { drawGhostLegend(painter, box, stillToCut); });
    }
    placeLegend();
}

/// As large as its text needs to be as large as that of the window.
void ViewOverlays::placeLegend() {
    const int height = static_cast<int>(4.2 * view_.fontMetrics().height());
    legend_->setGeometry(kMargin + kLetter, view_.height() - height - kMargin - kLetter, 4 * height, height);
}

void ViewOverlays::follow(const OrbitCamera& eye, ImageSize size, double mesialX) {
    placeLegend();
    if (aids_.scaleBar) placeScaleBar(eye, size);
    if (aids_.letters) placeLetters(eye, size, mesialX);
    if (aids_.cube) cube_->setEye(eye.camera().cameraInWorld.rotation, mesialX);
    placeCorners(size);
}

void ViewOverlays::placeScaleBar(const OrbitCamera& eye, ImageSize size) {
    const double perScreen = view_.devicePixelRatioF();
    const ScaleBar bar = scaleBar(1 / (eye.pixelPitch(size) * perScreen), kWidestBar);
    const int width = static_cast<int>(std::ceil(bar.pixels)) + 24;
    QRect place((view_.width() - width) / 2, view_.height() - kBarHeight - kMargin - kLetter, width, kBarHeight);
    const bool isInTheWay = !legend_->isHidden() && place.intersects(legend_->geometry());  // in a narrow picture
    if (isInTheWay) place.moveBottom(legend_->geometry().top() - kGap);
    constexpr double kSeen = 0.3;  // pixels
    if (place == scaleBar_->geometry() && std::abs(bar.pixels - shown_.pixels) < kSeen &&
        bar.millimetres == shown_.millimetres) {
        return;
    }
    shown_ = bar;
    scaleBar_->setGeometry(place);
    scaleBar_->setPaint([bar](QPainter& painter, const QRectF& box) { drawScaleBar(painter, box, bar); });
}

void ViewOverlays::placeLetters(const OrbitCamera& eye, ImageSize size, double mesialX) {
    const double perScreen = view_.devicePixelRatioF();
    const auto places = axisLetters(eye.camera(), size, mesialX, (kMargin / 2.0 + kLetter / 2.0) * perScreen);
    for (std::size_t i = 0; i < kAxisLetters; ++i) {
        const Vec2 corner = places[i].place / perScreen - Vec2::Constant(kLetter / 2.0);
        letters_[i]->setVisible(places[i].visible);
        if (places[i].visible) {
            letters_[i]->move(static_cast<int>(std::lround(corner.x())), static_cast<int>(std::lround(corner.y())));
        }
    }
}

void ViewOverlays::placeCorners(ImageSize size) {
    cube_->move(view_.width() - cube_->width() - kMargin - kLetter,
                view_.height() - cube_->height() - kMargin - kLetter);
    magnifier_->setGeometry(cornerGeometry(magnifierRectangle(size), view_.devicePixelRatioF()));
}

}  // namespace tactooth
