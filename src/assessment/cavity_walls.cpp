// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cavity_walls.h"

#include <algorithm>
#include <optional>

#include "collision/bvh/closest_point.h"
#include "geometry/mesh/append_subset.h"
#include "geometry/util/parallel_for.h"

// The distance to a surface is 1-Lipschitz, so an edge whose ends are both farther outside than it is long lies
// outside. All other edges are halved until they are short, equally for both of their triangles. The rest is cut along
// the straight line between the two changes of sign on a triangle's edges.

namespace tactooth {
namespace {

using Edge = std::array<std::uint32_t, 2>;  // lower vertex first

constexpr int kMaxRounds = 32;  // of halving: a metre becomes less than a nanometre

Edge edgeOf(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// A key of a triangle that does not depend on its first corner.
std::array<float, 9> cornersOf(const TriangleMesh& mesh, const Triangle& triangle) {
    std::array<std::array<float, 3>, 3> points;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3f& v = mesh.vertices[triangle[i]];
        points[i] = {v.x(), v.y(), v.z()};
    }
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    std::array<float, 9> corners;
    for (std::size_t i = 0; i < 9; ++i) corners[i] = points[i / 3][i % 3];
    return corners;
}

/// The triangles of `target` that are not triangles of the uncut surface: those of cavities.
std::vector<Triangle> newTriangles(const TriangleMesh& target, const TriangleMesh& uncut) {
    std::vector<std::array<float, 9>> known;
    known.reserve(uncut.triangles.size());
    for (const Triangle& triangle : uncut.triangles) known.push_back(cornersOf(uncut, triangle));
    std::sort(known.begin(), known.end());
    std::vector<Triangle> result;
    for (const Triangle& triangle : target.triangles) {
        const bool isKnown = std::binary_search(known.begin(), known.end(), cornersOf(target, triangle));
        if (!isKnown) result.push_back(triangle);
    }
    return result;
}

/// Triangles whose edges are halved, and for each vertex its height above the depth at which walls end, mm.
class Walls {
public:
    Walls(const TriangleMesh& target, const SurfacePart& outer) : outer_(outer) {
        mesh_.vertices = target.vertices;
        mesh_.triangles = newTriangles(target, outer.mesh());
        forgetUnusedVertices();
        measureFrom(0);
    }

    void halveLongEdges() {
        for (int round = 0; round < kMaxRounds; ++round) {
            const std::vector<Edge> halved = edgesWhere([&](const Edge& edge) { return mustBeHalved(edge); });
            if (halved.empty()) return;
            addVertices(halved, [](const Edge&) { return 0.5; });
            divideAt(halved);
        }
    }

    CavityWalls cutOff() && {
        const auto old = static_cast<std::uint32_t>(mesh_.vertices.size());
        const std::vector<Edge> crossed =
            edgesWhere([&](const Edge& edge) { return isInside(edge[0]) != isInside(edge[1]); });
        addVertices(crossed, [&](const Edge& edge) { return above_[edge[0]] / (above_[edge[0]] - above_[edge[1]]); });
        CavityWalls walls;
        for (const Triangle& triangle : mesh_.triangles) keepInside(triangle, crossed, old, walls);
        walls.mesh.vertices = std::move(mesh_.vertices);
        return walls;
    }

private:
    void forgetUnusedVertices() {
        TriangleMesh used;
        appendSubset(used, mesh_, [](std::uint32_t) { return true; });
        mesh_ = std::move(used);
    }

    void measureFrom(std::size_t first) {
        above_.resize(mesh_.vertices.size());
        constexpr std::size_t kGrain = 64;  // measures: about half a millisecond
        parallelFor(
            above_.size() - first,
            [&](std::size_t i) {
                const Vec3 vertex = mesh_.vertices[first + i].cast<double>();
                above_[first + i] = signedDistance(outer_, vertex) + kCavityDepth;
            },
            kGrain);
    }

    [[nodiscard]] bool isInside(std::uint32_t vertex) const { return above_[vertex] < 0; }

    [[nodiscard]] bool mustBeHalved(const Edge& edge) const {
        const double length = (mesh_.vertices[edge[0]] - mesh_.vertices[edge[1]]).cast<double>().norm();
        return length > kCavityEdge && std::min(above_[edge[0]], above_[edge[1]]) < length;
    }

    template <class Condition>
    [[nodiscard]] std::vector<Edge> edgesWhere(const Condition& condition) const {
        std::vector<Edge> edges;
        for (const Triangle& t : mesh_.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Edge edge = edgeOf(t[i], t[(i + 1) % 3]);
                if (condition(edge)) edges.push_back(edge);
            }
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        return edges;
    }

    /// Adds one vertex on each edge, in the order of the edges; `share`: its position along the edge, 0..1.
    template <class Share>
    void addVertices(const std::vector<Edge>& edges, const Share& share) {
        const std::size_t first = mesh_.vertices.size();
        for (const Edge& edge : edges) {
            const auto part = static_cast<float>(share(edge));
            mesh_.vertices.push_back((1 - part) * mesh_.vertices[edge[0]] + part * mesh_.vertices[edge[1]]);
        }
        measureFrom(first);
    }

    /// The vertex that was added on the edge from a to b, if there is one.
    static std::optional<std::uint32_t> vertexOn(const std::vector<Edge>& edges, std::size_t count, std::uint32_t a,
                                                 std::uint32_t b) {
        const auto found = std::lower_bound(edges.begin(), edges.end(), edgeOf(a, b));
        if (found == edges.end() || *found != edgeOf(a, b)) return std::nullopt;
        return static_cast<std::uint32_t>(count - edges.size() + static_cast<std::size_t>(found - edges.begin()));
    }

    void divideAt(const std::vector<Edge>& halved) {
        std::vector<Triangle> divided;
        divided.reserve(mesh_.triangles.size());
        const std::size_t count = mesh_.vertices.size();
        for (Triangle t : mesh_.triangles) {
            const auto middle = [&](std::size_t i) { return vertexOn(halved, count, t[i], t[(i + 1) % 3]); };
            int middles = 0;
            for (std::size_t i = 0; i < 3; ++i) middles += middle(i) ? 1 : 0;
            // Rotated so that the first edge is halved and, of two halved edges, the last one is not.
            while (middles > 0 && middles < 3 && (!middle(0) || (middles == 2 && middle(2)))) {
                std::rotate(t.begin(), t.begin() + 1, t.end());
            }
            if (middles == 0) {
                divided.push_back(t);
            } else if (middles == 1) {
                divided.insert(divided.end(), {{t[0], *middle(0), t[2]}, {*middle(0), t[1], t[2]}});
            } else if (middles == 2) {
                divided.insert(
                    divided.end(),
                    {{*middle(0), t[1], *middle(1)}, {t[0], *middle(0), *middle(1)}, {t[0], *middle(1), t[2]}});
            } else {
                divided.insert(divided.end(), {{t[0], *middle(0), *middle(2)},
                                               {t[1], *middle(1), *middle(0)},
                                               {t[2], *middle(2), *middle(1)},
                                               {*middle(0), *middle(1), *middle(2)}});
            }
        }
        mesh_.triangles = std::move(divided);
    }

    void keepInside(Triangle t, const std::vector<Edge>& crossed, std::uint32_t old, CavityWalls& walls) const {
        const auto inside = std::count_if(t.begin(), t.end(), [&](std::uint32_t v) { return isInside(v); });
        if (inside == 3) walls.mesh.triangles.push_back(t);
        if (inside == 0 || inside == 3) return;
        // Rotated so that the corner that differs from the two others comes first.
        while (isInside(t[0]) != (inside == 1)) std::rotate(t.begin(), t.begin() + 1, t.end());
        const std::size_t count = old + crossed.size();
        const std::uint32_t after = *vertexOn(crossed, count, t[0], t[1]);
        const std::uint32_t before = *vertexOn(crossed, count, t[2], t[0]);
        if (inside == 1) {
            walls.mesh.triangles.push_back({t[0], after, before});
            walls.rim.push_back({after, before});
        } else {
            walls.mesh.triangles.insert(walls.mesh.triangles.end(), {{after, t[1], t[2]}, {after, t[2], before}});
            walls.rim.push_back({before, after});
        }
    }

    const SurfacePart& outer_;
    TriangleMesh mesh_;
    std::vector<double> above_;
};

}  // namespace

CavityWalls cavityWalls(const TriangleMesh& target, const SurfacePart& outer) {
    Walls walls(target, outer);
    walls.halveLongEdges();
    return std::move(walls).cutOff();
}

std::optional<double> leastToPulp(const CavityWalls& walls, const LayeredTooth& tooth) {
    std::optional<double> least;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (!tooth.materials().hasRole(layer.material, MaterialRole::Pulp)) continue;
        for (const Vec3f& vertex : walls.mesh.vertices) {
            const double distance = signedDistance(*layer.part, vertex.cast<double>());
            least = std::min(least.value_or(distance), distance);
        }
    }
    return least;
}

}  // namespace tactooth
