// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/polygon_triangulation.h"

#include <algorithm>
#include <limits>

#include "geometry/util/assert.h"

// Source: ear clipping (G. Meisters, "Polygons Have Ears", American Mathematical Monthly 82, 1975). Differences: a
// bridge joins each hole to the outline first, and nearly flat ears come last.

namespace tactooth {
namespace {

using Points = std::vector<Vec2>;

/// A triangle counts as flat if its doubled area is less than this share of the square of its longer edge. Cut lines
/// are some hundredths of a millimetre long, and rounding to floats moves their ends by about 1e-6 mm.
constexpr double kFlat = 1e-4;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool properlyCross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
}

bool crossesLoop(const Points& points, const PolygonLoop& loop, std::uint32_t from, std::uint32_t to) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t a = loop[i];
        const std::uint32_t b = loop[(i + 1) % loop.size()];
        if (a == from || a == to || b == from || b == to) continue;
        if (properlyCross(points[from], points[to], points[a], points[b])) return true;
    }
    return false;
}

/// Position in the outline of the nearest corner that is visible from `from`, past the outline and all holes.
std::size_t nearestVisible(const Points& points, const PolygonLoop& outline, const std::vector<PolygonLoop>& holes,
                           std::uint32_t from) {
    TACTOOTH_ASSERT(!outline.empty());
    TACTOOTH_ASSERT(from < points.size());
    std::vector<std::size_t> order(outline.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto distance = [&](std::size_t i) { return (points[outline[i]] - points[from]).squaredNorm(); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    for (const std::size_t place : order) {
        const auto blocks = [&](const PolygonLoop& loop) { return crossesLoop(points, loop, from, outline[place]); };
        if (!blocks(outline) && std::none_of(holes.begin(), holes.end(), blocks)) return place;
    }
    return order.front();
}

void bridgeHoles(const Points& points, PolygonLoop& outline, std::vector<PolygonLoop> holes) {
    const auto rightmost = [&](const PolygonLoop& loop) {
        return std::max_element(loop.begin(), loop.end(),
                                [&](std::uint32_t a, std::uint32_t b) { return points[a].x() < points[b].x(); });
    };
    std::stable_sort(holes.begin(), holes.end(), [&](const PolygonLoop& a, const PolygonLoop& b) {
        return points[*rightmost(a)].x() < points[*rightmost(b)].x();
    });
    while (!holes.empty()) {
        PolygonLoop& hole = holes.back();
        TACTOOTH_ASSERT(hole.size() >= 3);
        std::rotate(hole.begin(), hole.begin() + (rightmost(hole) - hole.begin()), hole.end());
        const std::size_t place = nearestVisible(points, outline, holes, hole.front());
        TACTOOTH_ASSERT(place < outline.size());
        PolygonLoop bridge = hole;
        bridge.push_back(hole.front());
        bridge.push_back(outline[place]);
        outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(place) + 1, bridge.begin(), bridge.end());
        holes.pop_back();
    }
}

class EarClipper {
public:
    EarClipper(const Points& points, PolygonLoop loop) : points_(points), loop_(std::move(loop)) {}

    std::vector<Triangle> run() {
        std::vector<Triangle> triangles;
        triangles.reserve(loop_.size());
        std::size_t place = 0;
        while (loop_.size() > 3) {
            place = nextEar(place);
            TACTOOTH_ASSERT(place < loop_.size());
            triangles.push_back({before(place), loop_[place], after(place)});
            loop_.erase(loop_.begin() + static_cast<std::ptrdiff_t>(place));
            if (place >= loop_.size()) place = 0;
        }
        if (loop_.size() == 3) triangles.push_back({loop_[0], loop_[1], loop_[2]});
        return triangles;
    }

private:
    [[nodiscard]] std::uint32_t before(std::size_t i) const { return loop_[(i + loop_.size() - 1) % loop_.size()]; }
    [[nodiscard]] std::uint32_t after(std::size_t i) const { return loop_[(i + 1) % loop_.size()]; }
    [[nodiscard]] double turnAt(std::size_t i) const {
        return turn(points_[before(i)], points_[loop_[i]], points_[after(i)]);
    }

    /// The next ear from `from` on. Three corners on one line must not remain as one triangle, which would have no
    /// area. So a flat ear is taken only if there is no other. If rounding leaves no ear at all, the corner with the
    /// largest left turn is taken.
    [[nodiscard]] std::size_t nextEar(std::size_t from) const {
        for (const double tolerance : {kFlat, 0.0}) {
            for (std::size_t step = 0; step < loop_.size(); ++step) {
                const std::size_t place = (from + step) % loop_.size();
                if (turnAt(place) > tolerance * squaredSizeAt(place) && isEmpty(place, tolerance)) return place;
            }
        }
        const auto sharpest = [&](std::size_t a, std::size_t b) { return turnAt(b) > turnAt(a) ? b : a; };
        std::size_t best = from;
        for (std::size_t step = 1; step < loop_.size(); ++step) best = sharpest(best, (from + step) % loop_.size());
        return best;
    }

    /// Square of the longer one of the two edges at a corner.
    [[nodiscard]] double squaredSizeAt(std::size_t i) const {
        const Vec2& corner = points_[loop_[i]];
        return std::max((points_[before(i)] - corner).squaredNorm(), (points_[after(i)] - corner).squaredNorm());
    }

    [[nodiscard]] bool isEmpty(std::size_t ear, double tolerance) const {
        const Vec2& a = points_[before(ear)];
        const Vec2& b = points_[loop_[ear]];
        const Vec2& c = points_[after(ear)];
        const double least = -tolerance * squaredSizeAt(ear);
        for (std::size_t i = 0; i < loop_.size(); ++i) {
            const Vec2& p = points_[loop_[i]];
            if (p == a || p == b || p == c || turnAt(i) > tolerance * squaredSizeAt(i)) continue;
            if (turn(a, b, p) >= least && turn(b, c, p) >= least && turn(c, a, p) >= least) return false;
        }
        return true;
    }

    const Points& points_;
    PolygonLoop loop_;
};

}  // namespace

double doubledArea(const Points& points, const PolygonLoop& loop) {
    TACTOOTH_ASSERT(loop.empty() || loop.front() < points.size());
    double area = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        area += turn(points[loop[0]], points[loop[i]], points[loop[i + 1]]);
    }
    return area;
}

bool isWithin(const Points& points, const PolygonLoop& loop, const Vec2& point) {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2& a = points[loop[i]];
        const Vec2& b = points[loop[(i + 1) % loop.size()]];
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
}

std::vector<Triangle> triangulate(const Points& points, PolygonLoop outline, std::vector<PolygonLoop> holes) {
    TACTOOTH_ASSERT(outline.size() >= 3);
    bridgeHoles(points, outline, std::move(holes));
    const std::size_t corners = outline.size();
    std::vector<Triangle> triangles = EarClipper(points, std::move(outline)).run();
    TACTOOTH_ASSERT(triangles.size() + 2 == corners);
    return triangles;
}

}  // namespace tactooth
