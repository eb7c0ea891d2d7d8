// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QPolygonF>
#include <functional>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// How a surface takes the light in a SurfacePicture.
struct SurfaceFinish {
    Vec3 colour;       ///< sRGB, 0..1
    double shine;      ///< strength of the gloss, 0..1
    double sharpness;  ///< exponent of the gloss
};
inline const SurfaceFinish kSteelFinish{Vec3(0.74, 0.78, 0.83), 0.35, 24};
inline const SurfaceFinish kDiamondFinish{Vec3(0.80, 0.74, 0.62), 0.12, 8};

/// Side view of instruments on a clear ground, as an eye at -y sees them: x to the right, z up. Needs no OpenGL.
class SurfacePicture {
public:
    /// `left`, `bottom`: corner of what is shown, mm; `scale`: pixels for each mm.
    SurfacePicture(QSize size, double left, double bottom, double scale);

    /// `finishAt`: of the triangle whose middle is at a place.
    void add(const TriangleMesh& surface, const std::function<const SurfaceFinish&(const Vec3&)>& finishAt);
    [[nodiscard]] QImage drawn();

private:
    /// What the eye sees of a triangle.
    struct Facet {
        double depth;  // along y, mm: larger is farther
        QPolygonF corners;
        QColor colour;
    };

    QSize size_;
    double left_, bottom_, scale_;
    std::vector<Facet> facets_;
};

}  // namespace tactooth
