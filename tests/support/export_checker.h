// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <vector>

namespace tactooth::test {

/// Two facets of a file that meet elsewhere than in their common corners or edge.
struct SelfIntersection {
    std::size_t first, second;  ///< numbers of the facets in the file; equal for a facet without area
    /// mm; displacement along the other's normal that would separate them. 0: they touch, or overlap in one plane.
    double depth;
};

/// Result of an independent reader of an STL file: CGAL reads it, unites points of equal coordinates, and examines it.
/// Shares no code with the tested code.
struct ExportCheck {
    std::size_t facets = 0;
    std::size_t collapsed = 0;  ///< facets with two equal corners; all else is without them
    bool isManifold = false;    ///< every edge has two facets that run along it in opposite directions or one, every
                                ///< point has one fan of them; if false, the results below are not known
    bool isClosed = false;
    std::size_t components = 0;
    bool boundsVolume = false;  ///< the outermost components face outward, those inside them inward, and so on
    double volume = 0;          ///< mm^3
    std::vector<SelfIntersection> intersections;

    [[nodiscard]] bool isValid() const { return isManifold && isClosed && boundsVolume && volume > 0; }
    /// The number of intersections deeper than `depth`, mm.
    [[nodiscard]] std::size_t intersectionsDeeperThan(double depth) const;
    /// The greatest depth, mm; 0 if there is none.
    [[nodiscard]] double deepestIntersection() const;
};
std::ostream& operator<<(std::ostream& out, const ExportCheck& check);

[[nodiscard]] ExportCheck checkExport(const std::filesystem::path& stlFile);

}  // namespace tactooth::test
