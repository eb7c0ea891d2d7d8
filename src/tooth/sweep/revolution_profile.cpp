// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/sweep/revolution_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/util/assert.h"

// Own method. A plane of constant z cuts a triangle in a segment whose farthest point from the axis is one of its ends.
// So only the edges of the mesh matter. Along an edge the squared radius is a parabola in z, and the radius is a convex
// arc (a hyperbola or a line). Between two neighbouring vertex heights no arc begins or ends. The maximum of convex
// arcs is convex, and a chord never lies below it. So chords give a conservative profile.

namespace tactooth {
namespace {

using ProfilePoint = RevolutionProfilePoint;

constexpr double kSameHeight = 1e-6;        ///< mm; closer vertex heights count as one (rounding of an STL)
constexpr double kChordError = 0.0004;      ///< mm; largest distance of a chord from its arc
constexpr double kSimplification = 0.0002;  ///< mm; largest distance of a dropped corner from the simplified profile
constexpr double kShallow = 0.002;          ///< mm; a dent up to this depth is bridged

struct Edge {
    Vec3 low, high;
    [[nodiscard]] double radiusAt(double z) const {
        const double t = std::clamp((z - low.z()) / (high.z() - low.z()), 0.0, 1.0);
        const Vec3 point = low + t * (high - low);
        return std::hypot(point.x(), point.y());
    }
};

std::vector<double> vertexHeights(const TriangleMesh& mesh) {
    std::vector<double> heights;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) heights.push_back(mesh.corner(t, corner).z());
    }
    std::sort(heights.begin(), heights.end());
    std::vector<double> distinct;
    for (const double z : heights) {
        if (distinct.empty() || z > distinct.back() + kSameHeight) distinct.push_back(z);
    }
    return distinct;
}

/// Divides every gap wider than `step` into equal parts, so that chords stay close to their arcs.
std::vector<double> refined(const std::vector<double>& heights, double step) {
    TACTOOTH_ASSERT(heights.size() >= 2);
    TACTOOTH_ASSERT(std::isfinite(step) && step > 0);
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        const double gap = heights[i + 1] - heights[i];
        TACTOOTH_ASSERT(gap > 0);
        TACTOOTH_ASSERT(gap / step < std::numeric_limits<int>::max());
        const int parts = std::max(1, static_cast<int>(std::ceil(gap / step)));
        for (int part = 0; part < parts; ++part) result.push_back(heights[i] + gap * part / parts);
    }
    result.push_back(heights.back());
    return result;
}

/// Radius just above and just below each height. They differ at a flat shoulder.
struct Slab {
    double bottomRadius = 0;
    double topRadius = 0;
};

std::vector<Slab> slabs(const TriangleMesh& mesh, const std::vector<double>& heights) {
    TACTOOTH_ASSERT(heights.size() >= 2);
    std::vector<Slab> result(heights.size() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            Edge edge{mesh.corner(t, corner), mesh.corner(t, (corner + 1) % 3)};
            if (edge.low.z() > edge.high.z()) std::swap(edge.low, edge.high);
            const auto first = std::lower_bound(heights.begin(), heights.end(), edge.low.z() - kSameHeight);
            for (auto slab = first - heights.begin(); slab + 1 < static_cast<long>(heights.size()); ++slab) {
                if (heights[slab + 1] > edge.high.z() + kSameHeight) break;
                result[slab].bottomRadius = std::max(result[slab].bottomRadius, edge.radiusAt(heights[slab]));
                result[slab].topRadius = std::max(result[slab].topRadius, edge.radiusAt(heights[slab + 1]));
            }
        }
    }
    return result;
}

double distanceToChord(const ProfilePoint& point, const ProfilePoint& from, const ProfilePoint& to) {
    const double dr = to.radius - from.radius;
    const double dz = to.z - from.z;
    const double squared = dr * dr + dz * dz;
    const double along = (point.radius - from.radius) * dr + (point.z - from.z) * dz;
    const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
    return std::hypot(point.radius - from.radius - t * dr, point.z - from.z - t * dz);
}

/// Simplifies a polyline (D. Douglas, T. Peucker, "Algorithms for the reduction of the number of points required to
/// represent a digitized line or its caricature", 1973), with a stack instead of recursion.
std::vector<ProfilePoint> simplified(const std::vector<ProfilePoint>& points) {
    TACTOOTH_ASSERT(points.size() >= 2);
    std::vector<bool> kept(points.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        std::size_t farthest = from;
        double distance = kSimplification;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double d = distanceToChord(points[i], points[from], points[to]);
            if (d > distance) farthest = i, distance = d;
        }
        if (farthest == from) continue;
        kept[farthest] = true;
        open.push_back({from, farthest});
        open.push_back({farthest, to});
    }
    std::vector<ProfilePoint> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept[i]) result.push_back(points[i]);
    }
    return result;
}

/// Removes shallow dents. Each facet of a bur makes one (see above), and a profile without dents makes the sweep faster
/// (SweepLanes). The method is the scan of R. Graham, "An efficient algorithm for determining the convex hull of a
/// finite planar set", 1972. Difference: deep dents stay.
std::vector<ProfilePoint> bridged(const std::vector<ProfilePoint>& points) {
    std::vector<std::size_t> kept;
    const auto isDent = [&](std::size_t before, std::size_t at, std::size_t after) {
        const ProfilePoint &a = points[before], &b = points[at], &c = points[after];
        return (b.radius - a.radius) * (c.z - b.z) < (b.z - a.z) * (c.radius - b.radius);
    };
    const auto isShallow = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from + 1; i < to; ++i) {
            if (distanceToChord(points[i], points[from], points[to]) > kShallow) return false;
        }
        return true;
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        while (kept.size() >= 2 && isDent(kept[kept.size() - 2], kept.back(), i) &&
               isShallow(kept[kept.size() - 2], i)) {
            kept.pop_back();
        }
        kept.push_back(i);
    }
    TACTOOTH_ASSERT(kept.size() >= 2);
    TACTOOTH_ASSERT(kept.front() == 0 && kept.back() + 1 == points.size());
    std::vector<ProfilePoint> result;
    for (const std::size_t i : kept) result.push_back(points[i]);
    return result;
}

/// Moves the corners outward by the error of the simplification, so that the profile contains the mesh again.
void inflate(std::vector<ProfilePoint>& profile, bool wasSimplified) {
    TACTOOTH_ASSERT(profile.size() >= 2);
    if (!wasSimplified) return;
    for (std::size_t i = 1; i + 1 < profile.size(); ++i) profile[i].radius += kSimplification;
    profile.front().z -= kSimplification;
    profile[1].z -= kSimplification;
    profile.back().z += kSimplification;
    profile[profile.size() - 2].z += kSimplification;
}

}  // namespace

std::vector<ProfilePoint> revolutionProfile(const TriangleMesh& mesh) {
    const std::vector<double> levels = vertexHeights(mesh);
    if (levels.size() < 2) return {};
    double widest = 0;
    for (const Vec3f& vertex : mesh.vertices)
        widest = std::max(widest, std::hypot(double{vertex.x()}, double{vertex.y()}));
    // The hyperbola of an edge at distance a from the axis deviates from a chord by at most gap^2 / (8 a). Edges nearer
    // than a tenth of the largest radius never form the outline of a bur over a whole slab.
    TACTOOTH_ASSERT(std::isfinite(widest));
    const double step = std::sqrt(8 * 0.1 * std::max(widest, 1e-3) * kChordError);
    const std::vector<double> heights = refined(levels, step);

    std::vector<ProfilePoint> points = {{0, heights.front()}};
    const std::vector<Slab> all = slabs(mesh, heights);
    for (std::size_t i = 0; i < all.size(); ++i) {
        points.push_back({all[i].bottomRadius, heights[i]});
        points.push_back({all[i].topRadius, heights[i + 1]});
    }
    points.push_back({0, heights.back()});
    const auto isRepeated = [](const ProfilePoint& a, const ProfilePoint& b) {
        return std::abs(a.radius - b.radius) < 1e-9 && a.z == b.z;
    };
    points.erase(std::unique(points.begin(), points.end(), isRepeated), points.end());

    std::vector<ProfilePoint> profile = bridged(simplified(points));
    double error = 0;
    for (const ProfilePoint& point : points) {
        double nearest = kSimplification;
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            nearest = std::min(nearest, distanceToChord(point, profile[i], profile[i + 1]));
        }
        error = std::max(error, nearest);
    }
    inflate(profile, error > 1e-9);
    TACTOOTH_ASSERT(profile.front().radius < 1e-9 && profile.back().radius < 1e-9);
    return profile;
}

}  // namespace tactooth
