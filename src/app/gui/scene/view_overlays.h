// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "app/common/view_marks.h"
#include "app/gui/settings/window_settings.h"
#include "view/camera/orbit_camera.h"
#include "view/mesh/distance_colour.h"

class QWidget;

namespace tactooth {

class ViewCube;

/// What lies over the tooth's picture: scale bar, letters of the directions, view cube, frame of the magnifier, legend
/// of the colours. Each is a small widget of its own: a picture of motion repaints only what has changed.
class ViewOverlays final : public QObject {
    Q_OBJECT

public:
    /// They are children of `view`, and hidden until the first call of `choose`.
    explicit ViewOverlays(QWidget& view);

    /// Chooses what is visible. `magnifies`: whether the picture has a magnified part now.
    void choose(const ViewAids& aids, bool magnifies);
    /// Shows what the colours of the tooth or those of a ghost in it mean; neither: nothing.
    void showLegend(const std::optional<DistanceScale>& scale, bool hasGhost);
    /// Follows the eye. `size`: of the picture in pixels.
    void follow(const OrbitCamera& eye, ImageSize size, double mesialX);
    [[nodiscard]] ViewCube& cube() { return *cube_; }

private:
    class Mark;
    void placeScaleBar(const OrbitCamera& eye, ImageSize size);
    void placeLetters(const OrbitCamera& eye, ImageSize size, double mesialX);
    void placeLegend();
    void placeCorners(ImageSize size);

    QWidget& view_;
    ViewAids aids_;
    ScaleBar shown_;
    Mark* scaleBar_;
    std::array<Mark*, kAxisLetters> letters_ = {};
    Mark* magnifier_;
    Mark* legend_;
    ViewCube* cube_;
};

}  // namespace tactooth
