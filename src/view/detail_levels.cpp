// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/detail_levels.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cassert>

#include "geometry/parallel_for.h"

namespace tactooth {

namespace {

constexpr std::size_t kLeastTriangles = 20000;  ///< a bur, a handpiece: their triangles are larger than pixels

/// A few triangles with vertices of their own, numbered from 0, as meshoptimizer wants them.
class Piece {
public:
    explicit Piece(std::span<const ShadingVertex> vertices) : vertices_(vertices) {}

    void add(const Triangle& triangle) {
        for (const std::uint32_t vertex : triangle) indices_.push_back(vertex), all_.push_back(vertex);
    }

    std::vector<Triangle> coarsened(float error) {
        if (indices_.empty()) return {};
        std::sort(all_.begin(), all_.end());
        all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
        std::vector<std::array<float, 3>> positions;
        positions.reserve(all_.size());
        for (const std::uint32_t vertex : all_) positions.push_back(vertices_[vertex].position);
        for (std::uint32_t& index : indices_) {
            index = static_cast<std::uint32_t>(std::lower_bound(all_.begin(), all_.end(), index) - all_.begin());
        }
        constexpr std::size_t kStride = sizeof positions[0];
        const float* first = positions.front().data();
        const float scale = meshopt_simplifyScale(first, positions.size(), kStride);
        std::vector<std::uint32_t> fewer(indices_.size());
        fewer.resize(meshopt_simplify(fewer.data(), indices_.data(), indices_.size(), first, positions.size(), kStride,
                                      0, error / std::max(scale, 1e-6F), meshopt_SimplifyLockBorder));
        std::vector<Triangle> result;
        result.reserve(fewer.size() / 3);
        for (std::size_t i = 0; i < fewer.size(); i += 3) {
            result.push_back({all_[fewer[i]], all_[fewer[i + 1]], all_[fewer[i + 2]]});
        }
        return result;
    }

private:
    std::span<const ShadingVertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<std::uint32_t> all_;  ///< the vertices in use
};

}  // namespace

std::vector<Triangle> coarsened(std::span<const ShadingVertex> vertices, std::span<const Triangle> triangles,
                                float error) {
    // One piece for each look of which whole triangles are made; there are few.
    std::vector<std::pair<std::uint32_t, Piece>> pieces;
    std::vector<Triangle> kept;
    for (const Triangle& triangle : triangles) {
        const std::uint32_t looks = vertices[triangle[0]].looks;
        if (vertices[triangle[1]].looks != looks || vertices[triangle[2]].looks != looks) {
            kept.push_back(triangle);
            continue;
        }
        auto piece = std::find_if(pieces.begin(), pieces.end(), [&](const auto& one) { return one.first == looks; });
        if (piece == pieces.end()) piece = pieces.insert(pieces.end(), {looks, Piece(vertices)});
        piece->second.add(triangle);
    }
    std::vector<Triangle> result;
    for (auto& [looks, piece] : pieces) {
        const std::vector<Triangle> fewer = piece.coarsened(error);
        result.insert(result.end(), fewer.begin(), fewer.end());
    }
    result.insert(result.end(), kept.begin(), kept.end());
    return result;
}

DetailLevels::DetailLevels(const ShadingMesh& mesh) {
    if (mesh.triangles.size() < kLeastTriangles) return;
    const std::size_t count = (mesh.triangles.size() + kTrianglesPerGroup - 1) / kTrianglesPerGroup;
    groups_.resize(count);
    std::vector<std::array<std::vector<Triangle>, kStandOff.size()>> made(count);
    const std::span<const Triangle> all = mesh.triangles;
    parallelFor(count, [&](std::size_t g) {
        const std::size_t first = g * kTrianglesPerGroup;
        const auto own = all.subspan(first, std::min<std::size_t>(kTrianglesPerGroup, all.size() - first));
        const TriangleCluster ball = clusterOf(mesh.vertices, own);
        groups_[g].centre = ball.centre;
        groups_[g].radius = ball.radius;
        for (std::size_t level = 0; level < kStandOff.size(); ++level) {
            made[g][level] = coarsened(mesh.vertices, own, kStandOff[level]);
        }
    });
    for (std::size_t g = 0; g < count; ++g) {
        for (std::size_t level = 0; level < kStandOff.size(); ++level) {
            const std::span<const Triangle> fewer = made[g][level];
            const auto firstCluster = static_cast<std::uint32_t>(coarse_.size());
            for (std::size_t first = 0; first < fewer.size(); first += kTrianglesPerCluster) {
                const auto run =
                    fewer.subspan(first, std::min<std::size_t>(kTrianglesPerCluster, fewer.size() - first));
                TriangleCluster cluster = clusterOf(mesh.vertices, run);
                cluster.firstTriangle = static_cast<std::uint32_t>(all.size() + triangles_.size() + first);
                coarse_.push_back(cluster);
            }
            groups_[g].levels[level] = {firstCluster, static_cast<std::uint32_t>(coarse_.size()) - firstCluster};
            triangles_.insert(triangles_.end(), fewer.begin(), fewer.end());
        }
    }
}

std::span<const TriangleCluster> DetailLevels::clustersFor(std::size_t group, const ClusterCuller& culler,
                                                           std::span<const TriangleCluster> clusters,
                                                           bool isWhole) const {
    const Group& one = groups_[group];
    const float allowed = isWhole ? culler.allowedError(one.centre, one.radius) : 0;
    for (std::size_t level = kStandOff.size(); level-- > 0;) {
        if (kStandOff[level] > allowed) continue;
        return std::span(coarse_).subspan(one.levels[level].first, one.levels[level].second);
    }
    constexpr std::size_t kClusters = kTrianglesPerGroup / kTrianglesPerCluster;
    const std::size_t first = group * kClusters;
    return clusters.subspan(first, std::min(kClusters, clusters.size() - first));
}

void DetailLevels::visibleRuns(const ClusterCuller& culler, std::span<const TriangleCluster> clusters,
                               std::span<const std::uint32_t> hidden, std::vector<TriangleRun>& runs) const {
    if (groups_.empty()) return tactooth::visibleRuns(culler, clusters, runs);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        tactooth::visibleRuns(culler, clustersFor(g, culler, clusters, hidden[g] == 0), runs);
    }
}

}  // namespace tactooth
