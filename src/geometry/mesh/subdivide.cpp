// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// R. E. Bank, A. H. Sherman, A. Weiser, "Refinement algorithms and data structures for regular local mesh refinement",
// Scientific Computing, 1983: a triangle is split in four where three edges are halved, in three or two where fewer
// are. Ours has no temporary ("green") splits that have to be undone, since the surface is flat across each triangle
// whatever its shape.
#include "geometry/mesh/subdivide.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "geometry/mesh/mesh_edges.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr auto kWhole = std::numeric_limits<std::uint32_t>::max();  // the edge is not halved

/// Halves edges of a mesh, each in all its triangles at once, so that no vertex remains in the middle of an edge.
class EdgeSplitter {
public:
    explicit EdgeSplitter(const TriangleMesh& mesh)
        : mesh_(mesh), middle_(3 * mesh.triangles.size(), kWhole), count_(mesh.triangles.size()) {
        result_.vertices = mesh.vertices;
    }

    /// `uses`: the sides of the triangles at one edge.
    void halve(std::span<const EdgeUse> uses) {
        TACTOOTH_ASSERT(!uses.empty());
        TACTOOTH_ASSERT(result_.vertices.size() < kWhole);
        const auto vertex = static_cast<std::uint32_t>(result_.vertices.size());
        const std::uint32_t corner = uses.front().corner;
        TACTOOTH_ASSERT(middle_[corner] == kWhole);
        const Triangle& triangle = mesh_.triangles[corner / 3];
        const Vec3f& from = mesh_.vertices[triangle[corner % 3]];
        const Vec3f& to = mesh_.vertices[triangle[(corner + 1) % 3]];
        result_.vertices.emplace_back((0.5 * (from.cast<double>() + to.cast<double>())).cast<float>());
        for (const EdgeUse& use : uses) middle_[use.corner] = vertex;
        count_ += uses.size();
    }

    [[nodiscard]] std::size_t triangles() const { return count_; }

    [[nodiscard]] TriangleMesh result() && {
        result_.triangles.reserve(count_);
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) splitTriangle(t);
        TACTOOTH_ASSERT(result_.triangles.size() == count_);
        return std::move(result_);
    }

private:
    void splitTriangle(std::size_t t) {
        const std::uint32_t* middle = &middle_[3 * t];
        const auto halved = 3 - std::count(middle, middle + 3, kWhole);
        // Rotated so that a single halved edge, or a single whole one, comes first.
        const std::uint32_t* odd =
            std::find_if(middle, middle + 3, [&](std::uint32_t m) { return halved == 2 ? m == kWhole : m != kWhole; });
        const auto turn = odd == middle + 3 ? 0 : odd - middle;
        const Triangle& c = mesh_.triangles[t];
        const std::uint32_t a = c[turn], b = c[(turn + 1) % 3], d = c[(turn + 2) % 3];
        const std::uint32_t ab = middle[turn], bd = middle[(turn + 1) % 3], da = middle[(turn + 2) % 3];
        if (halved == 0) return add({c});
        if (halved == 1) return add({{a, ab, d}, {ab, b, d}});
        if (halved == 3) return add({{a, ab, da}, {ab, b, bd}, {da, bd, d}, {ab, bd, da}});
        add({{bd, d, da}});
        if (length(a, bd) <= length(b, da)) return add({{a, b, bd}, {a, bd, da}});
        add({{a, b, da}, {b, bd, da}});
    }

    void add(std::initializer_list<Triangle> triangles) {
        result_.triangles.insert(result_.triangles.end(), triangles.begin(), triangles.end());
    }
    [[nodiscard]] float length(std::uint32_t a, std::uint32_t b) const {
        return (result_.vertices[a] - result_.vertices[b]).norm();
    }

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> middle_;  // vertex in the middle of the side that begins at a corner
    std::size_t count_;
    TriangleMesh result_;
};

struct LongEdge {
    float length;
    std::span<const EdgeUse> uses;
};

/// The edges that one round may halve, longest first: those that are nearly as long as the longest.
std::vector<LongEdge> longEdges(const TriangleMesh& mesh, const MeshEdges& edges) {
    std::vector<LongEdge> all;
    float longest = 0;
    edges.forEachEdge([&](std::span<const EdgeUse> uses) {
        const std::uint32_t corner = uses.front().corner;
        const Triangle& triangle = mesh.triangles[corner / 3];
        const float length = (mesh.vertices[triangle[(corner + 1) % 3]] - mesh.vertices[triangle[corner % 3]]).norm();
        all.push_back({length, uses});
        longest = std::max(longest, length);
    });
    constexpr float kShortestShare = 0.7F;  // closer to 1 gives rounder triangles, but needs more rounds
    std::erase_if(all, [&](const LongEdge& edge) { return edge.length < kShortestShare * longest; });
    std::ranges::sort(all, [](const LongEdge& a, const LongEdge& b) {
        return std::make_tuple(-a.length, a.uses.front().corner) < std::make_tuple(-b.length, b.uses.front().corner);
    });
    return all;
}

}  // namespace

TriangleMesh subdivided(const TriangleMesh& mesh, int times) {
    TACTOOTH_ASSERT(times >= 0);
    TriangleMesh result = mesh;
    for (int round = 0; round < times; ++round) {
        const TriangleMesh coarse = std::move(result);
        EdgeSplitter splitter(coarse);
        const MeshEdges edges(coarse);
        edges.forEachEdge([&](std::span<const EdgeUse> uses) { splitter.halve(uses); });
        result = std::move(splitter).result();
        TACTOOTH_ASSERT(result.triangles.size() <= kMaxSubdivided);
    }
    return result;
}

TriangleMesh subdividedTo(const TriangleMesh& mesh, std::size_t triangles) {
    TriangleMesh result = mesh;
    while (result.triangles.size() < triangles) {
        const TriangleMesh coarse = std::move(result);
        const MeshEdges edges(coarse);
        EdgeSplitter splitter(coarse);
        for (const LongEdge& edge : longEdges(coarse, edges)) {
            if (splitter.triangles() >= triangles) break;
            splitter.halve(edge.uses);
        }
        result = std::move(splitter).result();
        if (result.triangles.size() == coarse.triangles.size()) break;  // no triangle has an edge that can be halved
    }
    return result;
}

}  // namespace tactooth
