// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// S. Gottschalk, "Separating axis theorem", TR96-024, UNC Chapel Hill (1996): two convex bodies are apart if their
// shadows on a normal of one of their faces, or on a direction square to an edge of each, are. Differs: bodies that
// share a corner are told apart by directions that have that corner between them.
#include "geometry/self_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "geometry/parallel_for.h"

namespace tactooth {
namespace {

constexpr double kApart = 1e-6;  // mm: far above the rounding of double precision, far below that of the vertices

using Corners = std::array<Vec3, 3>;

/// Lowest and highest place of points along a direction.
std::pair<double, double> shadow(std::span<const Vec3> points, const Vec3& direction) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& point : points) {
        const double place = direction.dot(point);
        low = std::min(low, place);
        high = std::max(high, place);
    }
    return {low, high};
}

Vec3 unit(const Vec3& v) {
    const double length = v.norm();
    constexpr double kNone = 1e-12;
    return length > kNone ? Vec3(v / length) : Vec3(Vec3::Zero());
}

bool partsThem(const Vec3& direction, const Corners& a, const Corners& b) {
    const auto [lowA, highA] = shadow(a, direction);
    const auto [lowB, highB] = shadow(b, direction);
    return lowB - highA > kApart || lowA - highB > kApart;
}

/// Two triangles without a common corner.
bool strangersMeet(const Corners& a, const Corners& b) {
    const auto edges = [](const Corners& t) { return Corners{t[1] - t[0], t[2] - t[1], t[0] - t[2]}; };
    const Corners edgesA = edges(a), edgesB = edges(b);
    const Vec3 normalA = unit(edgesA[0].cross(edgesA[1])), normalB = unit(edgesB[0].cross(edgesB[1]));
    if (partsThem(normalA, a, b) || partsThem(normalB, a, b)) return false;
    for (const Vec3& edge : edgesA) {
        if (partsThem(unit(edge.cross(normalA)), a, b)) return false;
        for (const Vec3& other : edgesB) {
            if (partsThem(unit(edge.cross(other)), a, b)) return false;
        }
    }
    return std::ranges::none_of(edgesB, [&](const Vec3& edge) { return partsThem(unit(edge.cross(normalB)), a, b); });
}

using Sides = std::array<Vec3, 2>;

/// Whether the plane through the common corner, square to `direction`, has one triangle on each side. A side of each
/// may lie in the plane.
bool partsCones(const Vec3& direction, const Sides& a, const Sides& b) {
    const auto [lowA, highA] = shadow(a, direction);
    const auto [lowB, highB] = shadow(b, direction);
    constexpr double kInPlane = 1e-9;
    return (highA < kInPlane && lowB > -kInPlane && lowA < -kApart && highB > kApart) ||
           (highB < kInPlane && lowA > -kInPlane && lowB < -kApart && highA > kApart);
}

/// Two triangles with one common corner; unit vectors from there along their sides.
bool conesMeet(const Sides& a, const Sides& b) {
    constexpr double kSame = 1 - 1e-12;  // cosine
    for (const Vec3& side : a) {
        for (const Vec3& other : b) {
            if (side.dot(other) > kSame) return true;
        }
    }
    const Vec3 normalA = unit(a[0].cross(a[1])), normalB = unit(b[0].cross(b[1]));
    const auto parts = [&](const Vec3& direction) { return partsCones(direction, a, b); };
    for (const Vec3& side : a) {
        if (parts(unit(side.cross(normalA)))) return false;
        for (const Vec3& other : b) {
            if (parts(unit(side.cross(other)))) return false;
        }
    }
    if (std::ranges::any_of(b, [&](const Vec3& side) { return parts(unit(side.cross(normalB))); })) return false;
    // The plane of one of them: the other one may touch it in the corner alone.
    const auto isBeside = [](const Vec3& normal, const Sides& other) {
        const auto [low, high] = shadow(other, normal);
        return low > kApart || high < -kApart;
    };
    return !isBeside(normalA, b) && !isBeside(normalB, a);
}

/// Two triangles with a common edge, folded onto each other; vectors from one end of it.
bool leavesMeet(const Vec3& edge, const Vec3& a, const Vec3& b) {
    const Vec3 along = unit(edge);
    const Vec3 outA = unit(a - along.dot(a) * along), outB = unit(b - along.dot(b) * along);
    constexpr double kFolded = 1 - 1e-10;  // cosine: an angle of 1e-5
    return outA.dot(outB) > kFolded;
}

class CrossingFinder {
public:
    explicit CrossingFinder(const TriangleMesh& mesh) : mesh_(mesh) { fillCells(); }
    [[nodiscard]] std::vector<std::uint32_t> crossing() const;

private:
    struct Entry {
        std::uint64_t cell;
        std::uint32_t triangle;
        auto operator<=>(const Entry&) const = default;
    };
    [[nodiscard]] Corners corners(std::uint32_t t) const {
        return {mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
    }
    [[nodiscard]] Box3 boxOf(std::uint32_t t) const {
        Box3 box;
        for (const Vec3& corner : corners(t)) box.extend(corner);
        return box;
    }
    void fillCells();
    [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b) const;

    const TriangleMesh& mesh_;
    std::vector<Box3> boxes_;
    std::vector<Entry> entries_;  // by cell
};

/// Each triangle in all cells of a regular grid that its box reaches into.
void CrossingFinder::fillCells() {
    Box3 all;
    double sum = 0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        const Box3 box = boxOf(t);
        boxes_.emplace_back(box.min().array() - kApart, box.max().array() + kApart);
        all.extend(boxes_.back());
        sum += boxes_.back().sizes().maxCoeff();
    }
    if (boxes_.empty()) return;
    constexpr double kBits = 1 << 20;  // cells along an axis that a number of a cell has room for
    const double size = std::max(sum / static_cast<double>(boxes_.size()), all.sizes().maxCoeff() / kBits);
    if (size <= 0) return;
    const auto cellOf = [&](const Vec3& p) { return Eigen::Vector3i(((p - all.min()) / size).cast<int>()); };
    for (std::uint32_t t = 0; t < boxes_.size(); ++t) {
        const Eigen::Vector3i low = cellOf(boxes_[t].min()), high = cellOf(boxes_[t].max());
        for (int x = low.x(); x <= high.x(); ++x) {
            for (int y = low.y(); y <= high.y(); ++y) {
                for (int z = low.z(); z <= high.z(); ++z) {
                    entries_.push_back({(std::uint64_t(x) << 42) | (std::uint64_t(y) << 21) | std::uint64_t(z), t});
                }
            }
        }
    }
    std::ranges::sort(entries_);
}

bool CrossingFinder::meet(std::uint32_t a, std::uint32_t b) const {
    const Triangle &first = mesh_.triangles[a], &second = mesh_.triangles[b];
    Corners cornersA = corners(a), cornersB = corners(b);
    // Common corners to the front of both.
    int common = 0;
    std::array<std::uint32_t, 3> namesB = second;
    for (int i = 0; i < 3; ++i) {
        const auto found = std::find(namesB.begin() + common, namesB.end(), first[i]);
        if (found == namesB.end()) continue;
        const auto place = found - namesB.begin();
        std::swap(cornersA[i], cornersA[common]);
        std::swap(namesB[place], namesB[common]);
        std::swap(cornersB[place], cornersB[common]);
        ++common;
    }
    if (common == 0) return strangersMeet(cornersA, cornersB);
    const Vec3& from = cornersA[0];
    if (common == 1) {
        return conesMeet({unit(cornersA[1] - from), unit(cornersA[2] - from)},
                         {unit(cornersB[1] - from), unit(cornersB[2] - from)});
    }
    return common == 3 || leavesMeet(cornersA[1] - from, cornersA[2] - from, cornersB[2] - from);
}

std::vector<std::uint32_t> CrossingFinder::crossing() const {
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (i == 0 || entries_[i].cell != entries_[i - 1].cell) begins.push_back(i);
    }
    begins.push_back(entries_.size());
    std::vector<std::vector<std::uint32_t>> found(begins.size() - 1);
    parallelFor(found.size(), [&](std::size_t cell) {
        for (std::size_t i = begins[cell]; i < begins[cell + 1]; ++i) {
            for (std::size_t k = i + 1; k < begins[cell + 1]; ++k) {
                const std::uint32_t a = entries_[i].triangle, b = entries_[k].triangle;
                if (!boxes_[a].intersects(boxes_[b]) || !meet(a, b)) continue;
                found[cell].push_back(a);
                found[cell].push_back(b);
            }
        }
    });
    std::vector<std::uint32_t> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace

std::vector<std::uint32_t> selfCrossings(const TriangleMesh& mesh) { return CrossingFinder(mesh).crossing(); }

bool untangle(TriangleMesh& mesh, const std::vector<Vec3f>& home) {
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds; ++round) {
        const std::vector<std::uint32_t> crossing = selfCrossings(mesh);
        if (crossing.empty()) return true;
        std::vector<std::uint8_t> goes(mesh.vertices.size(), 0);
        for (const std::uint32_t t : crossing) {
            for (const std::uint32_t vertex : mesh.triangles[t]) goes[vertex] = 1;
        }
        for (int ring = 0; ring < round; ++ring) {
            std::vector<std::uint8_t> wider = goes;
            for (const Triangle& t : mesh.triangles) {
                if ((goes[t[0]] | goes[t[1]] | goes[t[2]]) == 0) continue;
                for (const std::uint32_t vertex : t) wider[vertex] = 1;
            }
            goes.swap(wider);
        }
        for (std::size_t i = 0; i < goes.size(); ++i) {
            if (goes[i] != 0) mesh.vertices[i] = home[i];
        }
    }
    return selfCrossings(mesh).empty();
}

}  // namespace tactooth
