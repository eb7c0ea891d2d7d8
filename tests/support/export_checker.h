// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <vector>

namespace tactooth::test {

/// Two facets of a file that meet elsewhere than in the corners or the edge that both have.
struct SelfIntersection {
    std::size_t first, second;  ///< numbers of the facets in the file; equal for a facet without area
    /// mm; how far one would have to be moved along the other's normal to be clear of it. 0: they touch, or overlap in
    /// one plane.
    double depth;
};

/// What an independent reader finds in an STL file: CGAL reads it, makes points of equal coordinates one, and judges.
/// Shares no code with what it judges.
struct ExportCheck {
    std::size_t facets = 0;
    std::size_t collapsed = 0;  ///< facets with two equal corners; what follows is judged without them
    bool isManifold = false;    ///< every edge has two facets that run along it in opposite directions or one, every
                                ///< point one fan of them; nothing below is known otherwise
    bool isClosed = false;
    std::size_t components = 0;
    bool boundsVolume = false;  ///< the outermost components face outward, those within them inward, and so on
    double volume = 0;          ///< mm^3
    std::vector<SelfIntersection> crossings;

    [[nodiscard]] bool isValid() const { return isManifold && isClosed && boundsVolume && volume > 0; }
    /// Crossings deeper than `depth`, mm.
    [[nodiscard]] std::size_t intersectionsDeeperThan(double depth) const;
    [[nodiscard]] double deepestIntersection() const;
};
std::ostream& operator<<(std::ostream& out, const ExportCheck& verdict);

[[nodiscard]] ExportCheck checkExport(const std::filesystem::path& stlFile);

}  // namespace tactooth::test
