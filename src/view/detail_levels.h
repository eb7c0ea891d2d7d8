// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/cluster_culling.h"

namespace tactooth {

/// Coarser triangles over the same vertices, for surfaces so fine that their triangles are as small as pixels: a third
/// of them then shows the same. The surface is divided into groups of neighbouring triangles; each is drawn in the
/// coarsest level that stands off by no more than ClusterCuller::allowedError. The rims of the groups are the same in
/// all levels, so that no gap opens between them, and triangles between two looks stay in all.
class DetailLevels {
public:
    /// None for a surface with few triangles.
    explicit DetailLevels(const ShadingMesh& mesh);

    /// Those of all coarser levels, to be placed right behind the surface's own.
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    /// The group that a triangle of the surface belongs to, by its place in drawing order.
    [[nodiscard]] static std::size_t groupOf(std::uint32_t place) { return place / kTrianglesPerGroup; }
    [[nodiscard]] std::size_t groups() const { return groups_.size(); }

    /// Adds to `runs` what may show. Groups of which some triangles are hidden are drawn in the surface's own.
    /// `clusters`: the surface's; `hidden`: how many triangles of each group are hidden.
    void visibleRuns(const ClusterCuller& culler, std::span<const TriangleCluster> clusters,
                     std::span<const std::uint32_t> hidden, std::vector<TriangleRun>& runs) const;

private:
    static constexpr std::uint32_t kTrianglesPerGroup = 16 * kTrianglesPerCluster;
    /// How far each level stands off, mm: a third of a pixel of a tooth that fills a screen, and of a whole mouth.
    static constexpr std::array<float, 2> kStandOff = {0.008F, 0.03F};

    struct Group {
        Vec3f centre;  ///< of a ball that holds it, object frame, mm
        float radius = 0;
        std::array<std::pair<std::uint32_t, std::uint32_t>, kStandOff.size()> levels;  ///< of `coarse_`: first, count
    };
    [[nodiscard]] std::span<const TriangleCluster> clustersFor(std::size_t group, const ClusterCuller& culler,
                                                               std::span<const TriangleCluster> clusters,
                                                               bool isWhole) const;

    std::vector<Group> groups_;
    std::vector<Triangle> triangles_;
    std::vector<TriangleCluster> coarse_;
};

/// `triangles` replaced by fewer that stand off from them by about `error` (mm) at most; their rim stays, and so do
/// triangles whose corners differ in their looks. In about the same order.
[[nodiscard]] std::vector<Triangle> coarsened(std::span<const ShadingVertex> vertices,
                                              std::span<const Triangle> triangles, float error);

}  // namespace tactooth
