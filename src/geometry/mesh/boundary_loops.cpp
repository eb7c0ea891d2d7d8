// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/boundary_loops.h"

#include <algorithm>
#include <map>

#include "geometry/mesh/mesh_edges.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// Takes closed chains of vertices out of a set of directed edges. No chain visits a vertex twice: a chain that returns
/// to a vertex is cut off there. So holes that share corners are separated.
class LoopFinder {
public:
    void add(std::uint32_t from, std::uint32_t to) { next_[from].push_back(to); }

    /// All loops. `broken` grows by the number of chains that do not close.
    std::vector<BoundaryLoop> take(std::size_t& broken) {
        while (!next_.empty()) {
            path_.assign(1, next_.begin()->first);
            onPath_.clear();
            onPath_[path_.front()] = 0;
            while (proceed()) {
            }
            broken += path_.size() > 1;
        }
        return std::move(loops_);
    }

private:
    bool proceed() {
        TACTOOTH_ASSERT(!path_.empty());
        TACTOOTH_ASSERT(onPath_.size() == path_.size());
        const auto here = next_.find(path_.back());
        if (here == next_.end()) return false;
        const std::uint32_t to = here->second.back();
        here->second.pop_back();
        if (here->second.empty()) next_.erase(here);
        const auto [place, isNew] = onPath_.try_emplace(to, path_.size());
        if (isNew) {
            path_.push_back(to);
            return true;
        }
        const std::size_t first = place->second;
        TACTOOTH_ASSERT(first < path_.size() && path_[first] == to);
        BoundaryLoop loop(path_.begin() + static_cast<std::ptrdiff_t>(first), path_.end());
        for (std::size_t i = first + 1; i < path_.size(); ++i) onPath_.erase(path_[i]);
        path_.resize(first + 1);
        std::rotate(loop.begin(), loop.begin() + 1, loop.end());
        loops_.push_back(std::move(loop));
        return true;
    }

    std::map<std::uint32_t, std::vector<std::uint32_t>> next_;
    BoundaryLoop path_;
    std::map<std::uint32_t, std::size_t> onPath_;
    std::vector<BoundaryLoop> loops_;
};

/// Removes the loops that are an isolated triangle of the mesh: filling one would double the triangle.
void keepIsolatedTriangles(const TriangleMesh& mesh, std::vector<BoundaryLoop>& loops, std::size_t& open) {
    const auto sortedOf = [](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        Triangle sorted = {a, b, c};
        std::ranges::sort(sorted);
        return sorted;
    };
    if (std::ranges::none_of(loops, [](const BoundaryLoop& loop) { return loop.size() == 3; })) return;
    std::vector<Triangle> known;
    known.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) known.push_back(sortedOf(a, b, c));
    std::ranges::sort(known);
    open += std::erase_if(loops, [&](const BoundaryLoop& loop) {
        return loop.size() == 3 && std::ranges::binary_search(known, sortedOf(loop[0], loop[1], loop[2]));
    });
}

}  // namespace

std::vector<BoundaryLoop> boundaryLoops(const TriangleMesh& mesh, std::size_t& open) {
    LoopFinder finder;
    MeshEdges(mesh).forEachEdge([&](std::span<const EdgeUse> uses) {
        if (uses.size() != 1) return;
        const std::uint32_t corner = uses[0].corner;
        const Triangle& triangle = mesh.triangles[corner / 3];
        finder.add(triangle[(corner % 3 + 1) % 3], triangle[corner % 3]);
    });
    std::vector<BoundaryLoop> loops = finder.take(open);
    open += std::erase_if(loops, [](const BoundaryLoop& loop) { return loop.size() < 3; });
    keepIsolatedTriangles(mesh, loops, open);
    return loops;
}

}  // namespace tactooth
