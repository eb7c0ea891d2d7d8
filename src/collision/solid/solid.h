// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/mesh/crack_weld.h"

namespace tactooth {

// The definition of a solid for every command and the window. A surface is closed if its triangles use each edge as
// often in one direction as in the other (`EdgeBalance`). A point is inside if a ray from it crosses the surface an odd
// number of times (`contains`). Shells are flipped so that their triangles face the outside in this sense: the outer
// wall faces outward, the wall of a void faces into the void. Bodies that overlap bound no solid.

/// Why a surface bounds no solid.
enum class SolidFlaw {
    None,
    Empty,             ///< no triangle with an area
    Open,              ///< edges with an odd number of triangles
    NonOrientable,     ///< a band that has only one side
    Overlapping,       ///< parts overlap, or the surface crosses itself
    SelfIntersecting,  ///< its triangles cross each other nearly everywhere
};

/// Flaws and repairs of a surface. Lengths in the unit of the mesh.
struct SolidReport {
    SolidFlaw flaw = SolidFlaw::None;
    CrackWeld cracks;
    std::size_t droppedDuplicates = 0;  ///< triangles that were stored twice, or back to back
    std::size_t droppedSpecks = 0;      ///< small pieces beside the largest body
    std::size_t flippedTriangles = 0;   ///< that faced the wrong side
    std::size_t shells = 0;             ///< sets of triangles connected over edges of two triangles
    std::size_t voids = 0;              ///< shells that are the wall of a void
    std::size_t openEdges = 0;          ///< of an open surface
    std::size_t selfIntersectingTriangles =
        0;               ///< triangles that intersect others elsewhere than at common edges and corners
    double overlap = 0;  ///< greatest thickness of a region that two parts share

    [[nodiscard]] bool isSolid() const { return flaw == SolidFlaw::None; }
};

struct SolidOptions {
    bool dropsSpecks = true;  ///< for an outer surface; the small pieces of a layer may be spots of decay
};

/// A surface after examination.
struct ExaminedSolid {
    TriangleMesh mesh;  ///< with its repairs; a sound surface keeps every bit
    SolidReport report;
};

/// Examines a surface, and repairs what has only one right repair: welds cracks from rounding, drops triangles that are
/// stored twice and specks far smaller than the largest body, and orients shells by their nesting. A few triangles may
/// cross by less than the resolution of a CT of a tooth (0.05 mm); they stay as they are. A second examination changes
/// nothing. 325,000 triangles take some 0.2 s on two processors.
[[nodiscard]] ExaminedSolid examineSolid(TriangleMesh mesh, const SolidOptions& options = {});

/// The repairs and assumptions as sentences that begin with `what` ("outer").
[[nodiscard]] std::vector<ImportNote> notesOn(const SolidReport& report, const Message& what);

/// Why `what` ("the surface of the tooth") is no solid, and what the user can do: a sentence without its full stop.
/// Empty if it is a solid.
[[nodiscard]] Message flawSentence(const SolidReport& report, const Message& what);

}  // namespace tactooth
