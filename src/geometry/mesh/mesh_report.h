// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A shell: a component of a mesh whose triangles are connected over common edges.
struct ShellReport {
    std::size_t triangles = 0;
    double signedVolume = 0;  ///< mm^3; negative if the shell is inside out, or is the wall of a void
    Box3 box;                 ///< mm
};

/// Properties of a surface, from its triangles and common vertices alone. Triangles with two equal corners count as
/// degenerate and for nothing else. Self-intersections are not examined.
struct MeshReport {
    std::size_t triangles = 0;             ///< all, as stored
    std::size_t vertices = 0;              ///< that a triangle uses
    std::size_t degenerateTriangles = 0;   ///< with two equal corners
    std::size_t flatTriangles = 0;         ///< with three corners in line, to the precision of a float
    std::size_t duplicateTriangles = 0;    ///< with the same three corners, in any order, as an earlier one
    std::size_t boundaryEdges = 0;         ///< with one triangle: the boundary of a hole
    std::size_t nonManifoldEdges = 0;      ///< with three or more triangles
    std::size_t oddEdges = 0;              ///< of these, with an odd number: the surface is not closed there
    std::size_t inconsistentEdges = 0;     ///< with two, four ... triangles that disagree on which side is outside
    std::size_t pinchedVertices = 0;       ///< where parts of the surface touch in this point only
    std::int64_t eulerCharacteristic = 0;  ///< vertices - edges + triangles; a pinched vertex counts once for each part
    double area = 0;                       ///< mm^2
    double signedVolume = 0;               ///< mm^3, by the divergence theorem; a true volume only if `watertight()`
    Box3 box;                              ///< mm; empty if there is no triangle
    std::vector<ShellReport> shells;       ///< largest first

    /// Every edge has an even number of triangles; parts of the surface may touch along edges of four or more.
    [[nodiscard]] bool closed() const { return !shells.empty() && boundaryEdges == 0 && oddEdges == 0; }
    /// Neighbouring triangles agree on which side is outside.
    [[nodiscard]] bool oriented() const { return inconsistentEdges == 0; }
    /// Closed and oriented: each edge is run through as often in one direction as in the other (`EdgeBalance`), and the
    /// surface has an inside.
    [[nodiscard]] bool watertight() const { return closed() && oriented(); }
    /// The surface has an inside, but its triangles face inward.
    [[nodiscard]] bool insideOut() const { return watertight() && signedVolume < 0; }
    /// The enclosed volume, mm^3; none if there is no inside.
    [[nodiscard]] std::optional<double> volume() const;
    /// The number of handles of all shells together (0 for a ball, 1 for a ring); none if there is no inside, or if
    /// parts of the surface touch along edges.
    [[nodiscard]] std::optional<std::int64_t> genus() const;
};

/// Examines `mesh` in time and memory in proportion to its size (325,000 triangles: about 0.1 s). The result does not
/// depend on the machine.
[[nodiscard]] MeshReport reportOn(const TriangleMesh& mesh);

/// The weaknesses of the surface for the user: one English sentence for each, none for a valid surface.
[[nodiscard]] std::vector<std::string> findings(const MeshReport& report);

}  // namespace tactooth
