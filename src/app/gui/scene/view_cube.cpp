// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/view_cube.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTransform>
#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

constexpr int kSide = 92;             // pixels of the widget
constexpr double kHalfEdge = 26;      // pixels: the corners of the cube stay inside the widget
constexpr double kTurnedAway = 0.08;  // of the normal toward the eye: thinner faces cannot be read or clicked

/// A face by its outward normal and the direction in which its text stands, as in the standard view from there.
/// x is mesial here.
struct FaceAxes {
    Vec3 normal, up;
    std::optional<StandardView> view;  // none: apical, which is no standard view
};
const std::array<FaceAxes, 6>& faceAxes() {
    static const std::array<FaceAxes, 6> kAxes = {{{Vec3::UnitZ(), -Vec3::UnitY(), StandardView::Occlusal},
                                                   {Vec3::UnitY(), Vec3::UnitZ(), StandardView::Buccal},
                                                   {-Vec3::UnitY(), Vec3::UnitZ(), StandardView::Lingual},
                                                   {Vec3::UnitX(), Vec3::UnitZ(), StandardView::Mesial},
                                                   {-Vec3::UnitX(), Vec3::UnitZ(), StandardView::Distal},
                                                   {-Vec3::UnitZ(), Vec3::UnitY(), std::nullopt}}};
    return kAxes;
}

}  // namespace

ViewCube::ViewCube(QWidget* parent) : QWidget(parent) {
    setObjectName("viewCube");
    setFocusPolicy(Qt::NoFocus);  // the tooth view receives the keys
    setMouseTracking(true);
    resize(sizeHint());
    place();
}

QSize ViewCube::sizeHint() const { return {kSide, kSide}; }

QString ViewCube::titleOf(std::size_t face) const {
    const std::array<QString, kFaces> titles = {tr("Occlusal"), tr("Buccal"), tr("Lingual"),
                                                tr("Mesial"),   tr("Distal"), tr("Apical")};
    return titles[face];
}

void ViewCube::setEye(const Quat& cameraRotation, double mesialX) {
    constexpr double kSeen = 0.004;  // rad: a tenth of a pixel at the corners
    if (eye_.angularDistance(cameraRotation) < kSeen && mesialX == mesialX_) return;
    eye_ = cameraRotation;
    mesialX_ = mesialX;
    place();
    update();
}

/// Projects the faces that are turned to the eye.
void ViewCube::place() {
    const Quat toEye = eye_.conjugate();
    const auto inTooth = [this](const Vec3& v) { return Vec3(mesialX_ * v.x(), v.y(), v.z()); };
    const QPointF middle(width() / 2.0, height() / 2.0);
    for (std::size_t i = 0; i < kFaces; ++i) {
        const Vec3 normal = toEye * inTooth(faceAxes()[i].normal);
        const Vec3 up = toEye * inTooth(faceAxes()[i].up);
        const Vec3 right = up.cross(normal);
        faces_[i] = {{}, normal.z()};
        if (normal.z() < kTurnedAway) continue;
        for (const auto& [x, y] : {std::pair(-1, 1), std::pair(1, 1), std::pair(1, -1), std::pair(-1, -1)}) {
            const Vec3 corner = kHalfEdge * (normal + x * right + y * up);
            faces_[i].outline << middle + QPointF(corner.x(), -corner.y());
        }
    }
}

std::optional<QPointF> ViewCube::middleOf(StandardView view) const {
    for (std::size_t i = 0; i < kFaces; ++i) {
        if (faceAxes()[i].view != view || faces_[i].outline.isEmpty()) continue;
        return (faces_[i].outline[0] + faces_[i].outline[2]) / 2;
    }
    return std::nullopt;
}

std::optional<std::size_t> ViewCube::faceAt(const QPointF& place) const {
    for (std::size_t i = 0; i < kFaces; ++i) {
        if (faces_[i].outline.containsPoint(place, Qt::OddEvenFill)) return i;
    }
    return std::nullopt;
}

void ViewCube::hover(std::optional<std::size_t> face) {
    if (face == hovered_) return;
    hovered_ = face;
    setCursor(face ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setToolTip(face ? tr("Click: %1").arg(titleOf(*face)) : QString());
    update();
}

void ViewCube::mouseMoveEvent(QMouseEvent* event) {
    hover(event->buttons() == Qt::NoButton ? faceAt(event->position()) : std::nullopt);
    if (!hovered_) event->ignore();
}

void ViewCube::leaveEvent(QEvent* event) {
    hover(std::nullopt);
    QWidget::leaveEvent(event);
}

void ViewCube::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) update();
    QWidget::changeEvent(event);
}

/// Beside the cube the mouse works as if it were not there.
void ViewCube::mousePressEvent(QMouseEvent* event) {
    const std::optional<std::size_t> face = faceAt(event->position());
    if (!face || event->button() != Qt::LeftButton) return event->ignore();
    if (const auto view = faceAxes()[*face].view) {
        emit viewChosen(*view);
    } else {
        emit apicalChosen();
    }
}

void ViewCube::drawFace(QPainter& painter, std::size_t face) const {
    constexpr double kText = 100;  // the square on which the text is laid out
    const Face& shown = faces_[face];
    const int light = static_cast<int>(70 + 90 * shown.squareOn);
    painter.setPen(QPen(QColor(240, 244, 247, 220), 1));
    painter.setBrush(hovered_ == face ? QColor(70, 120, 190, 235) : QColor(light, light + 8, light + 16, 225));
    painter.drawPolygon(shown.outline);
    const QPolygonF square(QList<QPointF>{{0, 0}, {kText, 0}, {kText, kText}, {0, kText}});
    QTransform onFace;
    if (!QTransform::quadToQuad(square, shown.outline, onFace)) return;
    painter.save();
    painter.setTransform(onFace, true);
    QFont font = painter.font();
    font.setPixelSize(24);
    font.setBold(true);
    const QString title = titleOf(face);
    const double wide = QFontMetricsF(font).horizontalAdvance(title);
    constexpr double kMost = 0.9 * kText;
    if (wide > kMost) font.setPixelSize(std::max(8, static_cast<int>(24 * kMost / wide)));
    painter.setFont(font);
    painter.setPen(shown.squareOn > 0.6 && hovered_ != face ? QColor(15, 20, 25) : QColor(250, 252, 255));
    painter.drawText(QRectF(0, 0, kText, kText), Qt::AlignCenter, title);
    painter.restore();
}

void ViewCube::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < kFaces; ++i) {
        if (!faces_[i].outline.isEmpty()) drawFace(painter, i);
    }
}

}  // namespace tactooth
