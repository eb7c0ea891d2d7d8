// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <array>
#include <optional>

#include "view/camera/orbit_camera.h"

namespace tactooth {

/// A small cube that turns with the tooth and says by its faces from where one looks. A click on a face asks for the
/// view from there.
class ViewCube final : public QWidget {
    Q_OBJECT

public:
    explicit ViewCube(QWidget* parent);

    /// Shows the cube as this eye sees the tooth. `mesialX`: direction of mesial along x.
    void setEye(const Quat& cameraRotation, double mesialX);
    /// The place on this widget of the middle of a face; none if that face is turned away.
    [[nodiscard]] std::optional<QPointF> middleOf(StandardView view) const;
    [[nodiscard]] QSize sizeHint() const override;

signals:
    void viewChosen(StandardView view);
    void apicalChosen();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    static constexpr std::size_t kFaces = 6;
    struct Face {
        QPolygonF outline;  ///< upper left corner of the text first, clockwise; empty: turned away
        double squareOn = 0;
    };
    [[nodiscard]] QString titleOf(std::size_t face) const;
    [[nodiscard]] std::optional<std::size_t> faceAt(const QPointF& place) const;
    void hover(std::optional<std::size_t> face);
    void place();
    void drawFace(QPainter& painter, std::size_t face) const;

    Quat eye_ = Quat::Identity();
    double mesialX_ = 1;
    std::array<Face, kFaces> faces_;
    std::optional<std::size_t> hovered_;
};

}  // namespace tactooth
