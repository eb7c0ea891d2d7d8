// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "app/gui/input/viewport.h"
#include "geometry/util/vec.h"
#include "instruments/mirror.h"

namespace tactooth {

/// Lines on the tooth: outlines of a cavity, of its boxes, of decay, and of zones where nothing may be cut.
struct OutlineMarks {
    enum class Kind { Cavity, Box, Decay, Forbidden };
    struct Line {
        Kind kind = Kind::Cavity;
        std::vector<Vec3> places;              ///< tooth frame, mm; closed ones end where they begin
        Vec3 outward = Vec3::UnitZ();          ///< from where it is seen; from behind it is faint
        std::vector<Vec3> handles = {};        ///< places that can be moved
        std::optional<std::size_t> held = {};  ///< the handle that the mouse is on
    };
    std::vector<Line> lines;
    QString hint;  ///< at the top; empty: none
};

/// Draws them over the tooth view.
class OutlineOverlay final : public QWidget {
    Q_OBJECT

public:
    explicit OutlineOverlay(QWidget* parent);

    /// Who draws on the tooth: the exercise that a student works on, and the editor of exercises.
    enum class Layer { Exercise, Editor };
    void setMarks(Layer layer, OutlineMarks marks);
    [[nodiscard]] const OutlineMarks& marks(Layer layer) const { return marks_[static_cast<std::size_t>(layer)]; }
    /// The eye, the size of the picture or the mouth mirror has changed. `glass`: what lies in front of it is drawn in
    /// it, too.
    void follow(const Viewport& picture, const std::optional<MirrorDisc>& glass);
    /// A place in the picture, pixels of the widget; none behind the eye.
    [[nodiscard]] std::optional<QPointF> pointOf(const Vec3& place) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QPolygonF polygonOf(const std::vector<Vec3>& places) const;
    [[nodiscard]] QPolygonF imageOf(const std::vector<Vec3>& places) const;
    void paintLine(QPainter& painter, const OutlineMarks::Line& line) const;
    void paintImage(QPainter& painter, const OutlineMarks::Line& line) const;
    void paintHint(QPainter& painter, const QString& hint) const;

    std::array<OutlineMarks, 2> marks_;  // by Layer
    Viewport picture_;
    std::optional<MirrorDisc> glass_;
};

}  // namespace tactooth
