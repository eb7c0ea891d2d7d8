// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"
#include "view/mesh/corner_shading.h"

namespace tactooth {

/// A vertex in the format of the shaders.
struct ShadingVertex {
    std::array<float, 3> position;  ///< object frame, mm
    std::uint32_t normal;           ///< unit vector, three signed 10-bit numbers (GL_INT_2_10_10_10_REV)
    std::uint32_t appearances;      ///< an AppearanceMix: first, second and share, one byte each from the lowest
};

/// Small enough that the normals of a cluster of a scanned tooth are similar (about 0.5 mm across at 60 um per edge).
/// Large enough that cluster tests cost nothing compared with drawing.
inline constexpr std::uint32_t kTrianglesPerCluster = 128;

/// A run of neighbouring triangles that is drawn or skipped as a unit.
struct TriangleCluster {
    std::uint32_t firstTriangle = 0;  ///< in drawing order
    std::uint32_t triangles = 0;
    Vec3f centre;        ///< of a ball that encloses the cluster, object frame, mm
    float radius = 0;    ///< mm
    Vec3f axis;          ///< unit axis of a cone that contains the normals of the cluster
    float coneSine = 2;  ///< sine of the cone's half angle; above 1: normals in all directions
};

/// A surface prepared for drawing. Its triangles are sorted along a space-filling curve, so that runs of them are small
/// patches. Whole clusters that point away or are outside the picture are then skipped without access to their
/// vertices.
struct ShadingMesh {
    std::vector<ShadingVertex> vertices;
    std::vector<Triangle> triangles;                 ///< in drawing order
    std::vector<std::uint32_t> drawIndexOfTriangle;  ///< position of triangle t of the surface in drawing order
    std::vector<TriangleCluster> clusters;
    Box3 box;  ///< object frame
};

/// `shading`: of the corners of `mesh` (cornerShading or patchShading).
[[nodiscard]] ShadingMesh shadingMesh(const TriangleMesh& mesh, const CornerShading& shading);

/// Adds the clusters of `triangles` from number `first` on to `clusters`.
void appendClusters(std::span<const ShadingVertex> vertices, std::span<const Triangle> triangles, std::uint32_t first,
                    std::vector<TriangleCluster>& clusters);

/// Packs a unit vector into 3 x 10 bits.
[[nodiscard]] std::uint32_t packNormal(const Vec3f& normal);
/// Packs in the format of ShadingVertex::appearances.
[[nodiscard]] std::uint32_t packAppearances(const AppearanceMix& mix);

}  // namespace tactooth
