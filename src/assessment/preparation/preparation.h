// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "assessment/cavity_walls.h"
#include "assessment/forbidden_zone.h"

namespace tactooth {

/// A prepared tooth, and what it is compared with. All in the frame of the uncut tooth, mm.
struct Preparation {
    std::shared_ptr<const SurfacePart> original;     ///< the uncut tooth, closed, without the bodies around it
    std::shared_ptr<const SurfacePart> prepared;     ///< as the student left it, closed
    std::shared_ptr<const SurfacePart> ideal;        ///< with the ideal preparation, closed
    Vec3 axis = Vec3::UnitZ();                       ///< unit: out of the preparation, toward the operator
    double mesialX = 1;                              ///< direction of mesial along x: 1 or -1
    std::shared_ptr<const LayeredTooth> tooth = {};  ///< the uncut tooth with its layers; null: not known
    std::vector<std::shared_ptr<const SurfacePart>> pulps = {};  ///< closed; empty: the files have none
    std::shared_ptr<const SurfacePart> neighbours = {};          ///< uncut; null: the files have none
    std::vector<std::shared_ptr<const SurfacePart>> gums = {};   ///< closed; empty: the files have none
    TriangleMesh cutNeighbours = {};                             ///< the pieces of surface that cutting them has made
    std::vector<ForbiddenZone> forbidden = {};                   ///< of the exercise
    double tolerance = 0.3;                                      ///< mm: of the exercise, else as teachers allow
};

/// Four directions around the axis of a preparation, unit, square to it.
struct DentalDirections {
    DentalDirections(const Vec3& axis, double mesialX);

    Vec3 axis, mesial, buccal;
    /// Whether the tooth has this direction around the axis: along a buccal axis there is no buccal wall.
    bool hasMesial, hasBuccal;
};

/// A piece of the cut surface that counts as flat.
struct Facet {
    Vec3 centre;  ///< mm
    Vec3 normal;  ///< unit, out of the remaining tooth
    double area;  ///< mm^2
};

/// The triangles of a mesh, in their order.
[[nodiscard]] std::vector<Facet> facetsOf(const TriangleMesh& mesh);

/// The surfaces that cutting has made: that of the student and the ideal one.
struct CutSurfaces {
    explicit CutSurfaces(const Preparation& preparation);

    CavityWalls cut, idealCut;
    std::vector<Facet> facets;  ///< of `cut`, in the order of its triangles
    Vec3 middle;                ///< of `cut`, or of `idealCut` if nothing was cut, mm
    /// Whether the walls face away from the middle, as those of a crown preparation do.
    bool isCrown = false;
};

}  // namespace tactooth
