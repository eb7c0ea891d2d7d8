// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/scan_preview.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/common/scene_builder.h"
#include "app/gui/input/picture_pixels.h"
#include "app/gui/scene/quick_settings.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr int kFrameMs = 66;         // between two pictures: software OpenGL can draw a scan as often as that
constexpr double kTurnSeconds = 14;  // of one turn
constexpr double kClick = 4;         // pixels of the screen: a hand that clicks moves less
constexpr double kMesial = 1;        // along x: nobody has said yet on which side of the mouth the tooth is
constexpr OrbitCamera::Direction kStart{1.25, 0.45};

}  // namespace

ScanPreview::ScanPreview(QWidget* parent) : QOpenGLWidget(parent), overlays_(new ViewOverlays(*this)) {
    setObjectName("scanPreview");
    setMinimumSize(300, 300);
    setCursor(Qt::CrossCursor);
    setAccessibleName(tr("The scan as it will stand"));
    setToolTip(tr("Click on the side of the cheek or lip. Drag to turn, wheel to zoom."));
    overlays_->choose({.glass = false, .scaleBar = true, .letters = true, .cube = false, .magnifier = false}, false);
    turning_.setInterval(kFrameMs);
    connect(&turning_, &QTimer::timeout, this, &ScanPreview::turnOn);
    eye_.setView(kStart);
}

ScanPreview::~ScanPreview() {
    forgetRenderer();
    // The base class destroys the context after this object has ceased to be a ScanPreview.
    if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
}

void ScanPreview::forgetRenderer() {
    if (!renderer_) return;
    makeCurrent();
    renderer_.reset();
    doneCurrent();
}

void ScanPreview::show(std::shared_ptr<const Surface> surface) {
    surface_ = std::move(surface);
    if (surface_ == nullptr) {
        turning_.stop();
        return update();
    }
    eye_.fit(surface_->base->tree().box(), pictureSize(*this).aspect());
    if (!wasHeld_) turning_.start();
    applyCamera();
}

void ScanPreview::turnOn() {
    constexpr double kHalfHeights = 4;  // pictures' half heights in a turn: see OrbitCamera::orbit
    const double share = kFrameMs / (1000 * kTurnSeconds);
    eye_.orbit(Vec2(-share * kHalfHeights * pictureSize(*this).height / 2.0, 0), pictureSize(*this));
    applyCamera();
}

void ScanPreview::applyCamera() {
    overlays_->follow(eye_, pictureSize(*this), kMesial);
    update();
}

void ScanPreview::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ScanPreview::forgetRenderer);
    // Where it cannot be drawn, the window itself has said so.
    if (Expected<Renderer> renderer = Renderer::create()) renderer_.emplace(std::move(*renderer));
}

void ScanPreview::paintGL() {
    if (!renderer_) return;
    SceneContents contents;
    contents.tooth = surface_;
    contents.camera = eye_.camera();
    (void)renderer_->render(makeScene(contents), defaultFramebufferObject(), pictureSize(*this), quickSettings());
}

void ScanPreview::resizeEvent(QResizeEvent* event) {
    QOpenGLWidget::resizeEvent(event);
    applyCamera();
}

void ScanPreview::mousePressEvent(QMouseEvent* event) {
    pressed_ = last_ = pixelAt(*this, event->position());
    isDrag_ = false;
    wasHeld_ = true;
    turning_.stop();
}

void ScanPreview::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) return;
    const Vec2 now = pixelAt(*this, event->position());
    isDrag_ = isDrag_ || (now - pressed_).norm() > kClick * devicePixelRatioF();
    if (!isDrag_) return;
    eye_.orbit(now - std::exchange(last_, now), pictureSize(*this));
    applyCamera();
}

void ScanPreview::mouseReleaseEvent(QMouseEvent* event) {
    if (isDrag_ || surface_ == nullptr || event->button() != Qt::LeftButton) return;
    const Ray ray = rayThrough(eye_.camera(), pictureSize(*this), pixelAt(*this, event->position()));
    const auto hit = firstHit(*surface_, ray);
    if (!hit) return;
    const Vec3 place = ray.origin + *hit * ray.direction;
    emit cheekChosen(std::atan2(place.y(), place.x()));
}

void ScanPreview::wheelEvent(QWheelEvent* event) {
    const double notches = notchesOf(*event);
    eye_.zoom(std::pow(kZoomStep, notches), pixelAt(*this, event->position()), pictureSize(*this));
    applyCamera();
    event->accept();
}

}  // namespace tactooth
