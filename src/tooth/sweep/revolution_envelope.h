// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"
#include "tooth/sweep/revolution_profile.h"

namespace tactooth {

/// A signed distance and its gradient.
struct FieldSample {
    double distance;  ///< mm, negative inside
    Vec3 gradient;    ///< unit
};

/// The segments of a profile that can be nearest to the points of a small region, in single precision for eight points
/// at a time. Heights count from the middle of the region.
struct ProfilePart {
    /// A straight segment. The position of a point along it and outside it, mm, is linear in radius and height.
    struct Piece {
        float directionR, directionZ;  ///< unit
        float along, outside;          ///< position of the point (0, 0)
        float length;
        /// The side of points that are nearest to an end of the segment: 1 (outside) where the profile is convex, else
        /// -1. The value at the start plus twice the value at the end.
        float sides;
    };
    std::array<Piece, 48> pieces;
    int pieceCount = 0;
    bool bulges = false;  ///< the segments are consecutive and convex: the distance is convex along straight paths
};

/// The solid that a bur fills while it spins about its axis (z of the tool frame, tip at the bottom). It is a solid of
/// revolution that contains every triangle of the bur's STL and exceeds it by less than 1 um.
class RevolutionEnvelope {
public:
    using ProfilePoint = RevolutionProfilePoint;

    /// Fails with a sentence if the mesh has no extent along z or has no triangle.
    [[nodiscard]] static Expected<RevolutionEnvelope> make(const TriangleMesh& bur);

    /// Exact signed distance of a point of the tool frame to the surface of revolution, with its gradient. The point is
    /// finite.
    [[nodiscard]] FieldSample sample(const Vec3& pointInTool) const;
    [[nodiscard]] double signedDistance(const Vec3& pointInTool) const;

    /// Finds the segments that can be nearest within `reach` (mm) of a point of the tool frame. `distance` is the
    /// distance of that point from the surface, of either sign. False if there are too many segments.
    [[nodiscard]] bool findPart(const Vec3& pointInTool, double distance, double reach, ProfilePart& part) const;

    /// From the axis at the bottom, along the outside, to the axis at the top.
    [[nodiscard]] const std::vector<ProfilePoint>& profile() const { return profile_; }
    [[nodiscard]] double maxRadius() const { return maxRadius_; }
    [[nodiscard]] double bottom() const { return profile_.front().z; }
    [[nodiscard]] double top() const { return profile_.back().z; }

    /// Asserts the invariants of the profile and of the search grid. Takes time in proportion to the grid.
    void validate() const;

private:
    struct Segment {
        ProfilePoint start;
        double directionR, directionZ;  ///< unit
        double length;
    };
    struct Nearest {
        double squaredDistance, offsetR, offsetZ;
        std::uint32_t segment;
        bool isWithin;  ///< nearest point within the segment, not at an end
    };

    explicit RevolutionEnvelope(std::vector<ProfilePoint> profile);
    void buildGrid();
    [[nodiscard]] Nearest nearest(double radius, double z, const std::uint16_t* first, const std::uint16_t* last) const;
    [[nodiscard]] Nearest nearest(double radius, double z) const;
    [[nodiscard]] bool bulgesAfter(std::size_t segment) const;
    [[nodiscard]] bool isInside(double radius, double z) const;
    [[nodiscard]] bool isInside(const Nearest& hit, double radius, double z) const;

    std::vector<ProfilePoint> profile_;
    std::vector<Segment> segments_;
    double maxRadius_ = 0;

    // Candidates for the nearest segment, for each cell of a grid over the half-plane around the profile.
    double cellSize_ = 0;
    double gridBottom_ = 0;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint32_t> cellStart_;
    std::vector<std::uint16_t> candidates_;
    std::vector<std::uint16_t> allSegments_;
};

}  // namespace tactooth
