// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/gui/input/viewport.h"
#include "session/control/surface_measure.h"

namespace tactooth {

/// Drawn over the tooth view: the places of a measurement, the line between them with its length, or their normals with
/// the angle; and at the top what to do next.
class MeasureOverlay final : public QWidget {
    Q_OBJECT

public:
    explicit MeasureOverlay(QWidget* parent);

    /// `pointer`: the place under the mouse, or none.
    void show(const SurfaceMeasure& measure, const std::optional<Vec3>& pointer, const Viewport& picture);
    /// Shows nothing.
    void showNothing();
    /// "3.42 mm", "92.4°"; empty without a result.
    [[nodiscard]] const QString& result() const { return mark_.result; }
    /// The places in the picture, pixels of the widget.
    [[nodiscard]] const std::vector<QPointF>& places() const { return mark_.places; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Mark {
        std::vector<QPointF> places;
        std::vector<QPolygonF> lines;  // between the places; or disc and normal of each
        std::optional<QPointF> pointer;
        QString result, hint;
    };
    [[nodiscard]] QRectF boxFor(const QString& text, const QPointF& middle) const;

    Mark mark_;
};

}  // namespace tactooth
