// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>
#include <QTimer>
#include <memory>
#include <optional>

#include "app/gui/scene/view_overlays.h"
#include "collision/bvh/surface.h"
#include "view/camera/orbit_camera.h"
#include "view/render/renderer.h"

namespace tactooth {

/// A scan as it will stand after the import. It turns slowly until the user takes hold of it: a drag turns it, the
/// wheel zooms. A click on a place of the surface says that the cheek is there.
class ScanPreview final : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit ScanPreview(QWidget* parent = nullptr);
    ~ScanPreview() override;

    /// `surface`: in the tooth frame, mm; null: nothing is shown, while the scan is being examined.
    void show(std::shared_ptr<const Surface> surface);
    [[nodiscard]] bool isTurning() const { return turning_.isActive(); }
    [[nodiscard]] const OrbitCamera& eye() const { return eye_; }

signals:
    /// The cheek is at `azimuth`, rad, about the long axis: 90 degrees is where it is taken to be now (+y).
    void cheekChosen(double azimuth);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void turnOn();
    void applyCamera();
    void forgetRenderer();

    std::shared_ptr<const Surface> surface_;
    OrbitCamera eye_;
    std::optional<Renderer> renderer_;
    ViewOverlays* overlays_;
    QTimer turning_;
    bool wasHeld_ = false;  // by the user: it does not begin to turn again
    Vec2 pressed_ = Vec2::Zero(), last_ = Vec2::Zero();
    bool isDrag_ = false;
};

}  // namespace tactooth
