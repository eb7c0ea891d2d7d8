// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"
#include "view/mesh/corner_shading.h"

namespace tactooth {

/// A vertex as the shaders read it.
struct ShadingVertex {
    std::array<float, 3> position;  ///< object frame, mm
    std::uint32_t normal;           ///< unit, three signed 10-bit numbers (GL_INT_2_10_10_10_REV)
    std::uint32_t appearances;      ///< a AppearanceMix: first, second and share, a byte each from the lowest
};

/// Small enough that a run of a scanned tooth looks one way (about 0.5 mm across at 60 um per edge), large enough that
/// testing runs costs nothing beside drawing them.
inline constexpr std::uint32_t kTrianglesPerCluster = 128;

/// A run of neighbouring triangles that is drawn or skipped as one.
struct TriangleCluster {
    std::uint32_t firstTriangle = 0;  ///< in drawing order
    std::uint32_t triangles = 0;
    Vec3f centre;        ///< of a ball that holds the run, object frame, mm
    float radius = 0;    ///< mm
    Vec3f axis;          ///< of a cone that holds the normals of the run, unit
    float coneSine = 2;  ///< sine of the cone's half angle; above 1 = the normals point everywhere
};

/// A surface prepared for drawing: triangles sorted along a space-filling curve, so that runs of them are small
/// patches; whole runs that look away or lie outside the picture are then skipped without touching their vertices.
struct ShadingMesh {
    std::vector<ShadingVertex> vertices;
    std::vector<Triangle> triangles;                 ///< in drawing order
    std::vector<std::uint32_t> drawIndexOfTriangle;  ///< where triangle t of the surface went in drawing order
    std::vector<TriangleCluster> clusters;
    Box3 box;  ///< object frame
};

/// `shading`: of the corners of `mesh` (cornerShading or patchShading).
[[nodiscard]] ShadingMesh shadingMesh(const TriangleMesh& mesh, const CornerShading& shading);

/// Adds to `clusters` the runs of `triangles` from number `first` on.
void appendClusters(std::span<const ShadingVertex> vertices, std::span<const Triangle> triangles, std::uint32_t first,
                    std::vector<TriangleCluster>& clusters);

/// A unit vector in 3 x 10 bits.
[[nodiscard]] std::uint32_t packNormal(const Vec3f& normal);
/// As ShadingVertex::looks.
[[nodiscard]] std::uint32_t packAppearances(const AppearanceMix& mix);

}  // namespace tactooth
