// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_edges.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

template <class Visit>
void forEachSide(const TriangleMesh& mesh, Visit&& visit) {
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const Triangle& corners = mesh.triangles[triangle];
        if (isDegenerate(corners)) continue;
        TACTOOTH_ASSERT(std::ranges::max(corners) < mesh.vertices.size());
        for (std::size_t side = 0; side < 3; ++side) {
            visit(static_cast<std::uint32_t>(3 * triangle + side), corners[side], corners[(side + 1) % 3]);
        }
    }
}

}  // namespace

MeshEdges::MeshEdges(const TriangleMesh& mesh) : firstUse_(mesh.vertices.size() + 1, 0) {
    TACTOOTH_ASSERT(mesh.triangles.size() < std::numeric_limits<std::uint32_t>::max() / 3);
    // A counting sort by the smaller vertex, then a sort of the few edges that leave each vertex.
    forEachSide(mesh, [&](std::uint32_t, std::uint32_t from, std::uint32_t to) { ++firstUse_[std::min(from, to)]; });
    std::exclusive_scan(firstUse_.begin(), firstUse_.end(), firstUse_.begin(), std::size_t{0});
    uses_.resize(firstUse_.back());
    std::vector<std::size_t> next(firstUse_.begin(), firstUse_.end() - 1);
    forEachSide(mesh, [&](std::uint32_t corner, std::uint32_t from, std::uint32_t to) {
        uses_[next[std::min(from, to)]++] = {std::max(from, to), corner, from < to};
    });
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        TACTOOTH_ASSERT(next[vertex] == firstUse_[vertex + 1]);
        std::sort(uses_.begin() + static_cast<std::ptrdiff_t>(firstUse_[vertex]),
                  uses_.begin() + static_cast<std::ptrdiff_t>(firstUse_[vertex + 1]),
                  [](const EdgeUse& a, const EdgeUse& b) {
                      return a.other != b.other ? a.other < b.other : a.corner < b.corner;
                  });
    }
}

EdgeBalance edgeBalance(const TriangleMesh& mesh) {
    // A counting sort gathers the sides at their lower vertex, where only a few meet.
    std::vector<std::size_t> start(mesh.vertices.size() + 1, 0);
    forEachSide(mesh, [&](std::uint32_t, std::uint32_t from, std::uint32_t to) { ++start[std::min(from, to) + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    struct HalfEdge {
        std::uint32_t high;
        int direction;
    };
    std::vector<HalfEdge> halves(start.back());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    forEachSide(mesh, [&](std::uint32_t, std::uint32_t from, std::uint32_t to) {
        halves[next[std::min(from, to)]++] = {std::max(from, to), from < to ? 1 : -1};
    });
    EdgeBalance result;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        TACTOOTH_ASSERT(next[v] == start[v + 1]);
        const std::span<HalfEdge> here(halves.data() + start[v], start[v + 1] - start[v]);
        std::ranges::sort(here, {}, &HalfEdge::high);
        for (std::size_t first = 0, last; first < here.size(); first = last) {
            int balance = 0;
            for (last = first; last < here.size() && here[last].high == here[first].high; ++last) {
                balance += here[last].direction;
            }
            const bool isOdd = (last - first) % 2 != 0;
            result.odd += isOdd;
            result.against += !isOdd && balance != 0;
        }
    }
    return result;
}

}  // namespace tactooth
