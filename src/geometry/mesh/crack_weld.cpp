// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/crack_weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/near_weld.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr std::array<double, 3> kTolerances = {1e-6, 1e-5, 1e-4};  // share of the size
constexpr double kOfUsualEdge = 0.05;

double quantile(std::vector<double>& values, double share) {
    TACTOOTH_ASSERT(!values.empty());
    TACTOOTH_ASSERT(share >= 0 && share <= 1);
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// The size of the region that most corners are in, whatever is far away.
double usualSize(const TriangleMesh& mesh) {
    constexpr double kOutliers = 0.01;  // share at each end
    Vec3 size;
    std::vector<double> places(mesh.triangles.size());
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t t = 0; t < places.size(); ++t) places[t] = mesh.corner(t, 0)[axis];
        const double low = quantile(places, kOutliers);
        size[axis] = quantile(places, 1 - kOutliers) - low;
    }
    return size.norm();
}

double usualEdge(const TriangleMesh& mesh) {
    std::vector<double> lengths(mesh.triangles.size());
    for (std::size_t t = 0; t < lengths.size(); ++t) lengths[t] = (mesh.corner(t, 1) - mesh.corner(t, 0)).norm();
    return quantile(lengths, 0.5);
}

std::vector<std::uint8_t> verticesOnOpenEdges(const TriangleMesh& mesh) {
    std::vector<std::uint8_t> isOpen(mesh.vertices.size(), 0);
    MeshEdges(mesh).forEachEdge([&](std::span<const EdgeUse> uses) {
        if (uses.size() % 2 == 0) return;
        const Triangle& triangle = mesh.triangles[uses[0].corner / 3];
        for (const std::uint32_t vertex : {triangle[uses[0].corner % 3], triangle[(uses[0].corner + 1) % 3]}) {
            isOpen[vertex] = 1;
        }
    });
    return isOpen;
}

std::size_t openEdges(const TriangleMesh& mesh) { return edgeBalance(mesh).odd; }

}  // namespace

CrackWeld weldCracks(TriangleMesh& mesh) {
    CrackWeld done;
    if (mesh.empty()) return done;
    std::size_t fewest = openEdges(mesh);
    if (fewest == 0) return done;
    const std::vector<std::uint8_t> mayMove = verticesOnOpenEdges(mesh);
    const double size = usualSize(mesh), most = kOfUsualEdge * usualEdge(mesh);
    const double widest = std::min(kTolerances.back() * size, most);
    if (!(widest > 0)) return done;
    std::size_t movable = 0;
    (void)weldedWithin(mesh, widest, &movable, mayMove);
    if (movable == 0) return done;
    std::optional<TriangleMesh> best;
    for (const double share : kTolerances) {
        const double tolerance = std::min(share * size, most);
        if (!(tolerance > 0) || tolerance == done.tolerance) break;
        std::size_t moved = 0;
        TriangleMesh welded = weldedWithin(mesh, tolerance, &moved, mayMove);
        if (moved == 0) continue;
        std::erase_if(welded.triangles, isDegenerate);
        removeDuplicates(welded);
        const std::size_t open = openEdges(welded);
        if (open >= fewest) continue;
        fewest = open;
        done = {moved, tolerance};
        best = std::move(welded);
        if (open == 0) break;
    }
    TACTOOTH_ASSERT(best.has_value() == (done.moved > 0));
    if (best) mesh = std::move(*best);
    return done;
}

std::size_t removeDuplicates(TriangleMesh& mesh) {
    // A counting sort gathers the triangles at their lowest corner, where only a few meet.
    struct Entry {
        std::uint64_t others;  // the two other corners, the lower one first
        std::uint32_t triangle;
        bool isTurned;  // runs from the lowest corner to the highest
    };
    std::vector<std::size_t> start(mesh.vertices.size() + 1, 0);
    for (const Triangle& t : mesh.triangles) {
        if (!isDegenerate(t)) ++start[*std::ranges::min_element(t) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<Entry> entries(start.back());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (isDegenerate(t)) continue;
        const auto lowest = std::ranges::min_element(t) - t.begin();
        const std::uint64_t a = t[(lowest + 1) % 3], b = t[(lowest + 2) % 3];
        entries[next[t[lowest]]++] = {std::min(a, b) << 32 | std::max(a, b), i, a > b};
    }
    std::vector<std::uint8_t> goes(mesh.triangles.size(), 0);
    bool isAny = false;
    for (std::size_t v = 0; v + 1 < start.size(); ++v) {
        const std::span<Entry> here(entries.data() + start[v], start[v + 1] - start[v]);
        std::ranges::stable_sort(here, {}, &Entry::others);
        for (std::size_t first = 0, last; first < here.size(); first = last) {
            std::size_t turned = 0;
            for (last = first; last < here.size() && here[last].others == here[first].others; ++last) {
                turned += here[last].isTurned;
            }
            const std::size_t straight = last - first - turned;
            bool stays = turned != straight;  // one triangle of the more frequent direction stays
            for (std::size_t i = first; i < last && last - first > 1; ++i) {
                const bool isOfMore = here[i].isTurned == (turned > straight);
                goes[here[i].triangle] = !(stays && isOfMore);
                if (isOfMore) stays = false;
                isAny = true;
            }
        }
    }
    if (!isAny) return 0;
    std::vector<Triangle> kept;
    for (std::size_t t = 0; t < goes.size(); ++t) {
        if (goes[t] == 0) kept.push_back(mesh.triangles[t]);
    }
    const std::size_t dropped = mesh.triangles.size() - kept.size();
    mesh.triangles = std::move(kept);
    return dropped;
}

}  // namespace tactooth
