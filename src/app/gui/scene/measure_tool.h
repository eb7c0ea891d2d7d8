// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "app/gui/scene/measure_overlay.h"

namespace tactooth {

/// Measures on the tooth of a view: while it is on, the left button and Enter mark places and press no bur.
class MeasureTool final : public QObject {
    Q_OBJECT

public:
    /// `view`: it is drawn over this widget, which owns it.
    explicit MeasureTool(QWidget& view);

    /// Begins to measure anew; nothing: ends it. Ignored while it is not allowed.
    void setKind(std::optional<MeasureKind> kind);
    [[nodiscard]] std::optional<MeasureKind> kind() const;
    [[nodiscard]] bool isOn() const { return measure_.has_value(); }
    /// Off: ends it, and nobody can begin.
    void setAllowed(bool allowed);
    [[nodiscard]] bool isAllowed() const { return allowed_; }
    /// Takes the marks away; where there are none, ends it.
    void clear();
    /// Another tooth has come: the marks belong to the one before, and a taper is that from above.
    void takeTooth();
    /// The direction of insertion from which a taper is measured: unit, out of the tooth. It clears the marks.
    void setAxis(const Vec3& axis);

    /// The mouse is over this pixel of the picture.
    void point(const Surface& surface, const Viewport& picture, const Vec2& pixel);
    /// A device points along this ray.
    void point(const Surface& surface, const Viewport& picture, const Ray& ray);
    /// Marks the place there; nothing where there is no surface. `tooth`: of the surface, with its pulp.
    void pick(const Surface& surface, const LayeredTooth& tooth, const Viewport& picture, const Vec2& pixel);
    void pick(const Surface& surface, const LayeredTooth& tooth, const Viewport& picture, const Ray& ray);
    /// The eye or the size of the picture has changed.
    void follow(const Viewport& picture);
    [[nodiscard]] const MeasureOverlay& overlay() const { return *overlay_; }

signals:
    /// Its kind, its places, or whether it is allowed.
    void changed();

private:
    void showChange();
    void show();

    QWidget& view_;
    MeasureOverlay* overlay_;
    std::optional<SurfaceMeasure> measure_;  // none: off
    std::optional<Vec3> pointer_;
    Vec3 axis_ = Vec3::UnitZ();
    Viewport picture_;
    bool allowed_ = true;
};

}  // namespace tactooth
