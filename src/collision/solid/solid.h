// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/mesh/crack_weld.h"

namespace tactooth {

// What is solid, for every command and the window. A surface is closed if each of its edges is run through as often in
// one direction as in the other (`EdgeBalance`). A point is inside if a ray from it crosses the surface an odd number
// of times (`contains`). Shells are turned so that their triangles look at the outside in this sense: the outer wall
// outward, the wall of a hollow into the hollow. Bodies that reach into each other bound no solid.

/// Why a surface bounds no solid.
enum class SolidFlaw {
    None,
    Empty,             ///< no triangle with an area
    Open,              ///< edges with an odd number of triangles
    NonOrientable,     ///< a band that has but one side
    Overlapping,       ///< parts reach into each other, or the surface crosses itself
    SelfIntersecting,  ///< its triangles cross each other nearly everywhere
};

/// What was found in a surface, and what was done about it. Lengths in the unit of the mesh.
struct SolidReport {
    SolidFlaw flaw = SolidFlaw::None;
    CrackWeld cracks;
    std::size_t droppedDuplicates = 0;  ///< triangles that were stored twice, or back to back
    std::size_t droppedSpecks = 0;      ///< pieces beside the largest body
    std::size_t flippedTriangles = 0;   ///< that looked the wrong way
    std::size_t shells = 0;             ///< what hangs together over edges of two triangles
    std::size_t hollows = 0;            ///< shells that are the wall of a hollow
    std::size_t openEdges = 0;          ///< of an open surface
    std::size_t selfIntersectingTriangles =
        0;               ///< triangles that meet others elsewhere than at common edges and corners
    double overlap = 0;  ///< how thick the room is that two parts claim, at most

    [[nodiscard]] bool isSolid() const { return flaw == SolidFlaw::None; }
};

struct SolidOptions {
    bool dropsSpecks = true;  ///< of an outer surface; the small pieces of a layer may be spots of decay
};

struct ExaminedSolid {
    TriangleMesh mesh;  ///< as it is used; a sound surface keeps every bit
    SolidReport report;
};

/// Examines a surface, and mends what is no matter of opinion: welds what rounding has parted, drops triangles that are
/// stored twice and specks far smaller than the largest body, and turns shells by how they are nested. A few triangles
/// that cross by less than a CT of a tooth resolves (0.05 mm) are left as they are. Doing it again changes nothing.
/// 325,000 triangles: some 0.2 s on two processors.
[[nodiscard]] ExaminedSolid examineSolid(TriangleMesh mesh, const SolidOptions& options = {});

/// What was done, and what is assumed, in sentences that begin with `what` ("outer").
[[nodiscard]] std::vector<ImportNote> notesOn(const SolidReport& report, const Message& what);

/// Why `what` ("the surface of the tooth") is no solid, and what to do: a sentence without its full stop; empty if it
/// is one.
[[nodiscard]] Message flawSentence(const SolidReport& report, const Message& what);

}  // namespace tactooth
