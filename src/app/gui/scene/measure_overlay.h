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

/// Drawn over the tooth view: the places of a measurement, the line between them with its length, or their normals or
/// walls with the angle; and at the top what to do next.
class MeasureOverlay final : public QWidget {
    Q_OBJECT

public:
    explicit MeasureOverlay(QWidget* parent);

    /// `pointer`: the place under the mouse, or none.
    void show(const SurfaceMeasure& measure, const std::optional<Vec3>& pointer, const Viewport& picture);
    /// Shows nothing.
    void showNothing();
    /// "3.42 mm", "92.4°", "12.4° (8.1°, 4.3°)"; empty without a result.
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
    [[nodiscard]] static QString resultText(const SurfaceMeasure& measure, double result);
    [[nodiscard]] static QString whatText(MeasureKind kind);
    /// What to do next.
    [[nodiscard]] static QString nextText(const SurfaceMeasure& measure);
    [[nodiscard]] QRectF boxFor(const QString& text, const QFont& font, const QPointF& middle) const;

    Mark mark_;
};

}  // namespace tactooth
