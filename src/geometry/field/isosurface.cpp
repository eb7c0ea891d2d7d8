// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/field/isosurface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/field/dual_mesher.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

// Dual marching cubes (see dual_mesher.cpp), then relaxation as in S. Gibson, "Constrained elastic surface nets",
// MICCAI 1998. Ours ends with Newton steps that put the vertices onto the exact surface.

namespace tactooth {
namespace {

/// The gradient of the field, from values beside the point where it is `value`.
Vec3 gradientAt(const ScalarField& field, const Vec3& point, double value, double reach) {
    const double step = 1e-3 * reach;  // far below a cell, far above rounding
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 ahead = point;
        ahead[axis] += step;
        gradient[axis] = (field(ahead) - value) / step;
    }
    return gradient;
}

/// One step of Newton's method along the gradient, not farther than `reach`.
Vec3 projected(const Vec3& point, double value, const Vec3& gradient, double reach) {
    constexpr double kFlat = 1e-6;  // squared slope below which there is no direction
    const double squared = gradient.squaredNorm();
    if (squared < kFlat) return point;
    const Vec3 move = -value / squared * gradient;
    const double length = move.norm();
    return point + (length > reach ? reach / length : 1.0) * move;
}

/// Neighbours of each vertex along the polygons' edges, in one array.
class Neighbours {
public:
    explicit Neighbours(const DualMesh& mesh) : begin_(mesh.vertices.size() + 1, 0) {
        forEachCorner(mesh, [&](std::uint32_t, std::uint32_t here, std::uint32_t) { ++begin_[here + 1]; });
        for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        around_.resize(begin_.back());
        std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
        forEachCorner(mesh, [&](std::uint32_t before, std::uint32_t here, std::uint32_t after) {
            around_[next[here]++] = {before, after};
        });
    }

    /// Half of the displacement to the mean of the neighbours, but along the surface only.
    [[nodiscard]] Vec3 relaxed(std::size_t vertex, const std::vector<Vec3>& at) const {
        const Vec3& here = at[vertex];
        Vec3 sum = Vec3::Zero(), normal = Vec3::Zero();
        for (std::uint32_t i = begin_[vertex]; i < begin_[vertex + 1]; ++i) {
            const auto [before, after] = around_[i];
            sum += at[after] - here;
            normal += (at[after] - here).cross(at[before] - here);
        }
        const Vec3 move = 0.5 / (begin_[vertex + 1] - begin_[vertex]) * sum;
        const double squared = normal.squaredNorm();
        return squared > 0 ? Vec3(here + move - move.dot(normal) / squared * normal) : here;
    }

private:
    /// Each corner of each polygon: on the closed surface, each neighbour of a vertex follows it exactly once.
    template <class Function>
    static void forEachCorner(const DualMesh& mesh, const Function& function) {
        for (const auto& q : mesh.quads) {
            for (int i = 0; i < 4; ++i) function(q[(i + 3) % 4], q[i], q[(i + 1) % 4]);
        }
        for (const auto& t : mesh.triangles) {
            for (int i = 0; i < 3; ++i) function(t[(i + 2) % 3], t[i], t[(i + 1) % 3]);
        }
    }

    std::vector<std::uint32_t> begin_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> around_;
};

/// Relaxes the vertices and moves them onto the exact surface; none moves far from its cell. Returns the gradients
/// there.
std::vector<Vec3> relax(DualMesh& mesh, const ScalarField& field, const IsosurfaceOptions& options) {
    const Neighbours neighbours(mesh);
    const std::vector<Vec3> restPositions = mesh.vertices;
    std::vector<Vec3> moved(mesh.vertices.size()), gradients(mesh.vertices.size());
    const auto nearRest = [&](std::size_t i, const Vec3& target) -> Vec3 {
        const Vec3 away = target - restPositions[i];
        const double far = away.norm();
        return restPositions[i] + (far > options.cellSize ? options.cellSize / far : 1.0) * away;
    };
    for (int round = 0; round < options.relaxations; ++round) {
        parallelFor(moved.size(), [&](std::size_t i) { moved[i] = nearRest(i, neighbours.relaxed(i, mesh.vertices)); });
        mesh.vertices.swap(moved);
    }
    const double reach = options.cellSize / 2;
    parallelFor(moved.size(), [&](std::size_t i) {
        // The first step ends within a small part of a cell; the second, along the same gradient, on the surface.
        Vec3& at = mesh.vertices[i];
        const double value = field(at);
        gradients[i] = gradientAt(field, at, value, reach);
        at = nearRest(i, projected(at, value, gradients[i], reach));
        at = nearRest(i, projected(at, field(at), gradients[i], reach));
    });
    return gradients;
}

/// Approximate distance of the surface from the middle of the line between two of its points: that of a cubic arc with
/// their normals, up to a factor that is the same for all lines of about this length.
double sagBetween(const Vec3& a, const Vec3& slopeA, const Vec3& b, const Vec3& slopeB) {
    const double lengths = std::sqrt(slopeA.squaredNorm() * slopeB.squaredNorm());
    if (lengths == 0) return 0;
    return std::abs((b - a).dot(slopeA / slopeA.norm() - slopeB / slopeB.norm()));
}

/// Splits a quad along the diagonal whose middle is closer to the surface: ridges and valleys stay sharp.
std::array<Triangle, 2> split(const std::array<std::uint32_t, 4>& q, const std::vector<Vec3>& at,
                              const std::vector<Vec3>& slopes) {
    const double first = sagBetween(at[q[0]], slopes[q[0]], at[q[2]], slopes[q[2]]),
                 second = sagBetween(at[q[1]], slopes[q[1]], at[q[3]], slopes[q[3]]);
    if (first <= second) return {Triangle{q[0], q[1], q[2]}, Triangle{q[0], q[2], q[3]}};
    return {Triangle{q[0], q[1], q[3]}, Triangle{q[1], q[2], q[3]}};
}

}  // namespace

RelaxedSurface relaxedIsosurface(const ScalarField& field, const Box3& box, const IsosurfaceOptions& options) {
    TACTOOTH_ASSERT(options.cellSize > 0 && std::isfinite(options.cellSize));
    TACTOOTH_ASSERT(options.lipschitzBound > 0);
    TACTOOTH_ASSERT(options.relaxations >= 0);
    TACTOOTH_ASSERT(!box.isEmpty() && box.sizes().allFinite());
    DualMesh dual = DualMesher(SampledGrid(field, box, options)).mesh();
    RelaxedSurface surface;
    surface.restPositions.reserve(dual.vertices.size());
    for (const Vec3& vertex : dual.vertices) surface.restPositions.push_back(vertex.cast<float>());
    const std::vector<Vec3> slopes = relax(dual, field, options);

    TriangleMesh& mesh = surface.mesh;
    mesh.vertices.reserve(dual.vertices.size());
    for (const Vec3& vertex : dual.vertices) mesh.vertices.push_back(vertex.cast<float>());
    mesh.triangles.resize(2 * dual.quads.size());
    parallelFor(dual.quads.size(), [&](std::size_t i) {
        const auto halves = split(dual.quads[i], dual.vertices, slopes);
        std::ranges::copy(halves, mesh.triangles.begin() + static_cast<std::ptrdiff_t>(2 * i));
    });
    mesh.triangles.insert(mesh.triangles.end(), dual.triangles.begin(), dual.triangles.end());
    return surface;
}

TriangleMesh isosurface(const ScalarField& field, const Box3& box, const IsosurfaceOptions& options) {
    return relaxedIsosurface(field, box, options).mesh;
}

}  // namespace tactooth
