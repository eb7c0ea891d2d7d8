// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/patch_shading.h"

#include <array>
#include <map>

#include "collision/closest_point.h"
#include "view/tag_shares.h"

namespace tactooth {

namespace {

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

/// The looks of the base where a wall's vertex stands on it. A base triangle's tag stands for all of it, while a wall
/// knows its material to a few micrometres: without this, a scratch would show as a stripe of another colour.
std::optional<LookMix> looksOfRim(const SurfacePart& base, const CornerShading& shading, const Vec3& vertex) {
    const auto nearest = closestPoint(base, vertex, kOnBase);
    if (!nearest) return std::nullopt;
    return interpolated(base.mesh(), shading, nearest->triangle, nearest->point).mix;
}

/// The walls of several patches as one mesh. Neighbours meet in vertices of equal bits.
class JoinedWalls {
public:
    /// Adds the wall of `patch`, all of it or only what touches vertices that are there already.
    void add(const ShadedPatch& patch, bool onlyTouching) {
        const TriangleMesh& mesh = patch.part->mesh();
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            if (patch.carriedOn[t]) continue;
            const Triangle& corners = mesh.triangles[t];
            const auto isKnown = [&](std::uint32_t v) { return vertices_.contains(keyOf(mesh.vertices[v])); };
            if (onlyTouching && std::none_of(corners.begin(), corners.end(), isKnown)) continue;
            additions_.push_back({&patch, t});
        }
        // Only now: a neighbour's farther triangles do not count as touching.
        for (const auto& [from, t] : additions_) addTriangle(*from, t);
        additions_.clear();
    }

    [[nodiscard]] CornerShading shading() const { return cornerShading(mesh_, tags_); }

private:
    using Key = std::array<float, 3>;
    static Key keyOf(const Vec3f& v) { return {v.x(), v.y(), v.z()}; }

    void addTriangle(const ShadedPatch& patch, std::uint32_t t) {
        Triangle joined;
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec3f& vertex = patch.part->mesh().vertices[patch.part->mesh().triangles[t][c]];
            const auto [place, isNew] =
                vertices_.try_emplace(keyOf(vertex), static_cast<std::uint32_t>(mesh_.vertices.size()));
            if (isNew) mesh_.vertices.push_back(vertex);
            joined[c] = place->second;
        }
        mesh_.triangles.push_back(joined);
        tags_.push_back(patch.part->tag(t));
    }

    TriangleMesh mesh_;
    std::vector<SurfaceTag> tags_;
    std::map<Key, std::uint32_t> vertices_;
    std::vector<std::pair<const ShadedPatch*, std::uint32_t>> additions_;
};

}  // namespace

ShadedPatch::ShadedPatch(std::shared_ptr<const SurfacePart> patch, const SurfacePart& base) : part(std::move(patch)) {
    const TriangleMesh& mesh = part->mesh();
    carriedOn.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        carriedOn.push_back(baseTriangle(mesh, t, base));
        if (carriedOn.back()) continue;
        for (int corner = 0; corner < 3; ++corner) wall.extend(mesh.corner(t, corner));
    }
}

CornerShading patchShading(const ShadedPatch& patch, std::span<const ShadedPatch* const> neighbours,
                           const SurfacePart& base, const CornerShading& baseShading) {
    JoinedWalls walls;
    walls.add(patch, false);
    for (const ShadedPatch* neighbour : neighbours) walls.add(*neighbour, true);
    const CornerShading joined = walls.shading();

    const TriangleMesh& mesh = patch.part->mesh();
    CornerShading shading{std::vector<Vec3f>(3 * mesh.triangles.size()),
                          std::vector<LookMix>(3 * mesh.triangles.size())};
    std::size_t ofWall = 0;  // its triangles stand first among the joined ones, in their order
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            Corner corner;
            if (const auto& carried = patch.carriedOn[t]) {
                corner = interpolated(base.mesh(), baseShading, *carried, mesh.corner(t, static_cast<int>(c)));
            } else {
                const auto rim = looksOfRim(base, baseShading, mesh.corner(t, static_cast<int>(c)));
                corner = {joined.normals[3 * ofWall + c], rim.value_or(joined.looks[3 * ofWall + c])};
            }
            shading.normals[3 * t + c] = corner.normal;
            shading.looks[3 * t + c] = corner.mix;
        }
        ofWall += patch.carriedOn[t] ? 0 : 1;
    }
    return shading;
}

}  // namespace tactooth
