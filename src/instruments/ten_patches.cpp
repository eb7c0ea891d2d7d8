// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/ten_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kHalfWidth = 5;  // mm
constexpr double kBottom = -2;    // mm

/// Height over the plane z = 0: slopeX * x + slopeY * y + offset. The top of the block is the highest of the ten.
struct Patch {
    double slopeX, slopeY, offset;
    [[nodiscard]] double at(double x, double y) const { return slopeX * x + slopeY * y + offset; }
};

// A fissure along y: two pairs of gentle walls that fall toward the origin, steep walls beside them, one at each end.
constexpr std::array<Patch, TenPatches::kPatches> kTop = {{{0.5, 0.1, 0},
                                                           {-0.5, 0.1, 0},
                                                           {0.4, -0.25, 0},
                                                           {-0.4, -0.25, -0.1},
                                                           {2, 0.1, -3},
                                                           {-2, 0.1, -3.2},
                                                           {1.8, -0.25, -2.6},
                                                           {-1.8, -0.25, -2.7},
                                                           {0.1, 1.5, -5},
                                                           {-0.1, -1.4, -4.5}}};

/// Corners of the part of the square where patch `i` is the highest, counter-clockwise from above.
std::vector<Vec3> outlineOf(std::size_t i) {
    using Point = std::array<double, 2>;
    std::vector<Point> outline = {
        {-kHalfWidth, -kHalfWidth}, {kHalfWidth, -kHalfWidth}, {kHalfWidth, kHalfWidth}, {-kHalfWidth, kHalfWidth}};
    for (const Patch& other : kTop) {
        const Patch& own = kTop[i];
        const auto above = [&](const Point& p) { return own.at(p[0], p[1]) - other.at(p[0], p[1]); };
        std::vector<Point> kept;
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const Point& from = outline[k];
            const Point& to = outline[(k + 1) % outline.size()];
            const double begin = above(from);
            const double end = above(to);
            if (begin >= 0) kept.push_back(from);
            if ((begin > 0 && end < 0) || (begin < 0 && end > 0)) {
                const double share = begin / (begin - end);
                kept.push_back({from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])});
            }
        }
        outline = std::move(kept);
    }
    std::vector<Vec3> corners;
    for (const Point& p : outline) corners.emplace_back(p[0], p[1], kTop[i].at(p[0], p[1]));
    return corners;
}

/// Collects triangles; corners closer than a nanometre or two become one vertex.
class BlockMesh {
public:
    std::uint32_t vertex(const Vec3& point) {
        constexpr double kPerMm = 1e5;  // far finer than the patches, far coarser than rounding
        const std::array<long, 3> place = {std::lround(kPerMm * point.x()), std::lround(kPerMm * point.y()),
                                           std::lround(kPerMm * point.z())};
        const auto [found, isNew] = numbers_.try_emplace(place, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (isNew) mesh.vertices.push_back(point.cast<float>());
        return found->second;
    }
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh.triangles.push_back({a, b, c}); }

    TriangleMesh mesh;

private:
    std::map<std::array<long, 3>, std::uint32_t> numbers_;
};

/// Corners of the boundary, counter-clockwise from above.
std::vector<Vec3> rimOf(const TriangleMesh& top) {
    std::vector<Vec3> rim;
    for (const Vec3f& v : top.vertices) {
        if (std::max(std::abs(v.x()), std::abs(v.y())) == static_cast<float>(kHalfWidth)) {
            rim.push_back(v.cast<double>());
        }
    }
    std::ranges::sort(rim, {}, [](const Vec3& p) { return std::atan2(p.y(), p.x()); });
    return rim;
}

void addWallsAndBottom(BlockMesh& block) {
    const std::vector<Vec3> rim = rimOf(block.mesh);
    const std::uint32_t middle = block.vertex({0, 0, kBottom});
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const Vec3& from = rim[i];
        const Vec3& to = rim[(i + 1) % rim.size()];
        const std::uint32_t fromBelow = block.vertex({from.x(), from.y(), kBottom});
        const std::uint32_t toBelow = block.vertex({to.x(), to.y(), kBottom});
        block.add(fromBelow, toBelow, block.vertex(to));
        block.add(fromBelow, block.vertex(to), block.vertex(from));
        block.add(middle, toBelow, fromBelow);
    }
}

HalfSpace freeSpaceOf(const Patch& patch) {
    const Vec3 upward(-patch.slopeX, -patch.slopeY, 1);
    return {upward.normalized(), patch.offset / upward.norm()};
}

/// The point nearest to `target` on all half-spaces of `chosen`, if it is unique.
bool nearestOnAll(std::span<const HalfSpace> chosen, const Vec3& target, Vec3& point) {
    Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> normals(chosen.size(), 3);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> missing(chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        normals.row(row) = chosen[i].normal.transpose();
        missing(row) = chosen[i].offset - chosen[i].normal.dot(target);
    }
    const auto gram = (normals * normals.transpose()).eval();
    constexpr double kParallel = 1e-9;
    if (gram.determinant() < kParallel) return false;
    point = target + normals.transpose() * gram.inverse() * missing;
    return true;
}

}  // namespace

TenPatches makeTenPatches() {
    TenPatches piece;
    BlockMesh block;
    for (std::size_t i = 0; i < kTop.size(); ++i) {
        piece.first[i] = static_cast<std::uint32_t>(block.mesh.triangles.size());
        const std::vector<Vec3> outline = outlineOf(i);
        for (std::size_t k = 2; k < outline.size(); ++k) {
            block.add(block.vertex(outline[0]), block.vertex(outline[k - 1]), block.vertex(outline[k]));
        }
        piece.behind[i] = static_cast<std::uint32_t>(block.mesh.triangles.size());
        piece.freeSpace[i] = freeSpaceOf(kTop[i]);
    }
    addWallsAndBottom(block);
    piece.surface = std::move(block.mesh);
    piece.a = {1, 1, kTop[0].at(1, 1)};
    piece.b = {0, 1.5, kTop[0].at(0, 1.5)};
    piece.c = Vec3::Zero();
    return piece;
}

Vec3 nearestFreeTip(const TenPatches& piece, const TriangleMesh& tool, const Pose& device) {
    TACTOOTH_ASSERT(isRigid(device));
    TACTOOTH_ASSERT(!tool.vertices.empty());
    std::array<HalfSpace, TenPatches::kPatches> spaces = piece.freeSpace;
    for (HalfSpace& space : spaces) {  // half-spaces of the tip instead of the whole tool
        const Vec3 direction = device.rotation.conjugate() * space.normal;
        double lowest = std::numeric_limits<double>::infinity();
        for (const Vec3f& v : tool.vertices) lowest = std::min(lowest, direction.dot(v.cast<double>()));
        space.offset -= lowest;
    }
    const auto isFree = [&](const Vec3& tip) {
        constexpr double kRounding = 1e-12;  // mm
        return std::ranges::all_of(spaces,
                                   [&](const HalfSpace& s) { return s.normal.dot(tip) >= s.offset - kRounding; });
    };
    if (isFree(device.position)) return device.position;
    // The answer touches one, two or three half-spaces: of all candidates, the nearest that is free.
    Vec3 best = Vec3::Constant(std::numeric_limits<double>::infinity());
    const auto consider = [&](std::initializer_list<std::size_t> numbers) {
        std::vector<HalfSpace> chosen;
        for (const std::size_t number : numbers) chosen.push_back(spaces[number]);
        Vec3 tip;
        if (!nearestOnAll(chosen, device.position, tip) || !isFree(tip)) return;
        if ((tip - device.position).squaredNorm() < (best - device.position).squaredNorm()) best = tip;
    };
    for (std::size_t i = 0; i < spaces.size(); ++i) {
        consider({i});
        for (std::size_t j = 0; j < i; ++j) {
            consider({i, j});
            for (std::size_t k = 0; k < j; ++k) consider({i, j, k});
        }
    }
    return best;
}

}  // namespace tactooth
