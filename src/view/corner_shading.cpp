// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/corner_shading.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "collision/closest_point.h"

namespace tactooth {

namespace {

/// Which corners (3 t + c) touch each vertex.
struct CornersOfVertex {
    std::vector<std::uint32_t> begin;
    std::vector<std::uint32_t> corners;

    explicit CornersOfVertex(const TriangleMesh& mesh) : begin(mesh.vertices.size() + 1) {
        for (const Triangle& triangle : mesh.triangles) {
            for (const std::uint32_t vertex : triangle) ++begin[vertex + 1];
        }
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        corners.resize(3 * mesh.triangles.size());
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        for (std::size_t corner = 0; corner < corners.size(); ++corner) {
            corners[next[mesh.triangles[corner / 3][corner % 3]]++] = static_cast<std::uint32_t>(corner);
        }
    }
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t vertex) const {
        return {corners.data() + begin[vertex], corners.data() + begin[vertex + 1]};
    }
};

struct Facets {
    std::vector<Vec3f> normals;  ///< one a triangle; zero if it has no area
    std::vector<float> angles;   ///< one a corner, rad

    explicit Facets(const TriangleMesh& mesh) : normals(mesh.triangles.size()), angles(3 * mesh.triangles.size()) {
        for (std::size_t t = 0; t < normals.size(); ++t) {
            const std::array<Vec3f, 3> p = {mesh.vertices[mesh.triangles[t][0]], mesh.vertices[mesh.triangles[t][1]],
                                            mesh.vertices[mesh.triangles[t][2]]};
            normals[t] = (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
            for (std::size_t c = 0; c < 3; ++c) {
                const Vec3f a = p[(c + 1) % 3] - p[c];
                const Vec3f b = p[(c + 2) % 3] - p[c];
                angles[3 * t + c] = std::atan2(a.cross(b).norm(), a.dot(b));
            }
        }
    }
};

/// How much of each tag there is at a point.
class TagShares {
public:
    void clear() { shares_.clear(); }
    void add(SurfaceTag tag, float weight) {
        const auto known = std::find_if(shares_.begin(), shares_.end(), [&](const auto& s) { return s.tag == tag; });
        if (known != shares_.end()) {
            known->weight += weight;
        } else {
            shares_.push_back({tag, weight});
        }
    }
    [[nodiscard]] LookMix mix() {
        std::sort(shares_.begin(), shares_.end(), [](const Share& a, const Share& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.tag < b.tag;
        });
        if (shares_.empty()) return {};
        if (shares_.size() == 1) return {shares_[0].tag, shares_[0].tag, 0};
        const float both = shares_[0].weight + shares_[1].weight;
        const float share = both > 0 ? shares_[1].weight / both : 0;
        return {shares_[0].tag, shares_[1].tag, static_cast<std::uint8_t>(std::lround(255 * share))};
    }

private:
    struct Share {
        SurfaceTag tag;
        float weight;
    };
    std::vector<Share> shares_;
};

constexpr std::uint8_t kNoGroup = 255;
constexpr std::uint8_t kMostGroups = 254;

class VertexGrouping {
public:
    VertexGrouping(const TriangleMesh& mesh, const Facets& facets, std::span<const SurfaceTag> tags)
        : mesh_(mesh),
          facets_(facets),
          tags_(tags),
          groups_(3 * mesh.triangles.size(), kNoGroup),
          shading_{std::vector<Vec3f>(3 * mesh.triangles.size()), std::vector<LookMix>(3 * mesh.triangles.size())} {}

    [[nodiscard]] CornerShading takeShading() { return std::move(shading_); }

    void group(std::span<const std::uint32_t> corners) {
        std::uint8_t groups = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (groups_[corners[i]] != kNoGroup) continue;
            flood(corners, corners[i], groups);
            if (groups < kMostGroups) ++groups;
        }
        for (std::uint8_t g = 0; g < groups; ++g) shade(corners, g);
    }

private:
    /// Gives `group` to `seed` and to every corner that smooth edges join to it.
    void flood(std::span<const std::uint32_t> corners, std::uint32_t seed, std::uint8_t group) {
        front_.assign(1, seed);
        groups_[seed] = group;
        while (!front_.empty()) {
            const std::uint32_t current = front_.back();
            front_.pop_back();
            for (const std::uint32_t other : corners) {
                if (groups_[other] != kNoGroup || !smooth(current, other)) continue;
                groups_[other] = group;
                front_.push_back(other);
            }
        }
    }

    [[nodiscard]] bool smooth(std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t ta = a / 3;
        const std::uint32_t tb = b / 3;
        const Triangle& left = mesh_.triangles[ta];
        const Triangle& right = mesh_.triangles[tb];
        const std::uint32_t after = left[(a + 1 - 3 * ta) % 3];
        const std::uint32_t before = left[(a + 2 - 3 * ta) % 3];
        const bool shareAnEdge = after == right[(b + 2 - 3 * tb) % 3] || before == right[(b + 1 - 3 * tb) % 3];
        static const float kCreaseCosine = static_cast<float>(std::cos(kCreaseAngle));
        return shareAnEdge && facets_.normals[ta].dot(facets_.normals[tb]) >= kCreaseCosine;
    }

    void shade(std::span<const std::uint32_t> corners, std::uint8_t group) {
        Vec3f sum = Vec3f::Zero();
        shares_.clear();
        for (const std::uint32_t corner : corners) {
            if (groups_[corner] != group) continue;
            sum += facets_.angles[corner] * facets_.normals[corner / 3];
            shares_.add(tags_.empty() ? SurfaceTag{0} : tags_[corner / 3], facets_.angles[corner]);
        }
        const Vec3f normal = sum.squaredNorm() > 0 ? sum.normalized().eval() : Vec3f::UnitZ().eval();
        const LookMix mix = shares_.mix();
        for (const std::uint32_t corner : corners) {
            if (groups_[corner] != group) continue;
            shading_.normals[corner] = normal;
            shading_.looks[corner] = mix;
        }
    }

    const TriangleMesh& mesh_;
    const Facets& facets_;
    std::span<const SurfaceTag> tags_;
    std::vector<std::uint8_t> groups_;  ///< numbers the groups of each vertex from 0, one entry a corner
    CornerShading shading_;
    TagShares shares_;
    std::vector<std::uint32_t> front_;
};

/// A point this near to the base lies on it, mm: coordinates of a mouth in single precision are exact to 0.01 um, and
/// no cut follows the surface to 0.2 um.
constexpr double kOnBase = 2e-4;

/// The base triangle of which triangle `t` of the patch is a piece, if it is one.
std::optional<std::uint32_t> baseTriangle(const TriangleMesh& patch, std::uint32_t t, const SurfacePart& base) {
    const Vec3 centre = (patch.corner(t, 0) + patch.corner(t, 1) + patch.corner(t, 2)) / 3;
    const auto nearest = closestPoint(base, centre, kOnBase);
    if (!nearest) return std::nullopt;
    const Vec3 normal = base.mesh().areaVector(nearest->triangle).stableNormalized();
    for (int corner = 0; corner < 3; ++corner) {
        if (std::abs(normal.dot(patch.corner(t, corner) - nearest->point)) > kOnBase) return std::nullopt;
    }
    return nearest->triangle;
}

/// A corner of a patch: its normal and its looks.
struct Corner {
    Vec3f normal;
    LookMix mix;
};

/// The shading of base triangle `t` at `point`, which lies on it.
Corner interpolated(const TriangleMesh& base, const CornerShading& shading, std::uint32_t t, const Vec3& point) {
    const Vec3 area = base.areaVector(t);
    Vec3f sum = Vec3f::Zero();
    TagShares shares;
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const Vec3 a = base.corner(t, (corner + 1) % 3) - point;
        const Vec3 b = base.corner(t, (corner + 2) % 3) - point;
        const auto weight = static_cast<float>(std::max(0.0, a.cross(b).dot(area) / area.squaredNorm()));
        sum += weight * shading.normals[3 * t + corner];
        const LookMix& mix = shading.looks[3 * t + corner];
        const float second = static_cast<float>(mix.share) / 255;
        shares.add(mix.first, weight * (1 - second));
        if (mix.share > 0) shares.add(mix.second, weight * second);
    }
    return {sum.stableNormalized(), shares.mix()};
}

}  // namespace

CornerShading cornerShading(const TriangleMesh& mesh, std::span<const SurfaceTag> tags) {
    assert(tags.empty() || tags.size() == mesh.triangles.size());
    const Facets facets(mesh);
    const CornersOfVertex cornersOfVertex(mesh);
    VertexGrouping grouping(mesh, facets, tags);
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) grouping.group(cornersOfVertex.of(vertex));
    return grouping.takeShading();
}

CornerShading patchShading(const SurfacePart& patch, const SurfacePart& base, const CornerShading& baseShading) {
    const TriangleMesh& mesh = patch.mesh();
    CornerShading shading = cornerShading(mesh, patch.tags());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto carriedOn = baseTriangle(mesh, t, base);
        if (!carriedOn) continue;
        for (std::uint32_t c = 0; c < 3; ++c) {
            const Corner corner =
                interpolated(base.mesh(), baseShading, *carriedOn, mesh.corner(t, static_cast<int>(c)));
            shading.normals[3 * t + c] = corner.normal;
            shading.looks[3 * t + c] = corner.mix;
        }
    }
    return shading;
}

}  // namespace tactooth
