// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/patch_shading.h"

#include <algorithm>
#include <map>

#include "collision/bvh/closest_point.h"
#include "view/mesh/tag_weights.h"

namespace tactooth {

namespace {

/// A point this close to the base is on it, mm. Coordinates of a mouth in single precision are exact to 0.01 um, and no
/// cut follows the surface to 0.2 um.
constexpr double kOnBase = 2e-4;

/// The base triangle that contains triangle `t` of the patch, if there is one.
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

/// A corner of a patch: its normal and its appearances.
struct Corner {
    Vec3f normal;
    AppearanceMix mix;
};

/// The shading of base triangle `t`, interpolated at `point` on it.
Corner interpolated(const TriangleMesh& base, const CornerShading& shading, std::uint32_t t, const Vec3& point) {
    const Vec3 area = base.areaVector(t);
    Vec3f sum = Vec3f::Zero();
    TagWeights shares;
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const Vec3 a = base.corner(t, (corner + 1) % 3) - point;
        const Vec3 b = base.corner(t, (corner + 2) % 3) - point;
        const auto weight = static_cast<float>(std::max(0.0, a.cross(b).dot(area) / area.squaredNorm()));
        sum += weight * shading.normals[3 * t + corner];
        const AppearanceMix& mix = shading.appearances[3 * t + corner];
        const float second = static_cast<float>(mix.share) / 255;
        shares.add(mix.first, weight * (1 - second));
        if (mix.share > 0) shares.add(mix.second, weight * second);
    }
    return {sum.stableNormalized(), shares.mix()};
}

/// The appearances of the base at a wall vertex that is on the base. The tag of a base triangle holds for all of it,
/// but a wall knows its material to a few micrometres. Without this, a scratch would appear as a stripe of another
/// colour.
std::optional<AppearanceMix> rimAppearanceAt(const SurfacePart& base, const CornerShading& shading,
                                             const Vec3& vertex) {
    const auto nearest = closestPoint(base, vertex, kOnBase);
    if (!nearest) return std::nullopt;
    return interpolated(base.mesh(), shading, nearest->triangle, nearest->point).mix;
}

ShadedPatch::Position placeOf(const Vec3f& v) { return {v.x(), v.y(), v.z()}; }

/// The wall of a patch and the adjacent wall triangles of its neighbours, as one mesh. Shared vertices have bitwise
/// equal coordinates.
class JoinedWall {
public:
    explicit JoinedWall(const ShadedPatch& patch) : places_(patch.positions) {
        for (const ShadedPatch::Position& place : places_) mesh_.vertices.emplace_back(place.data());
        const auto isOwn = [](std::uint32_t) { return true; };
        addTriangles(patch, isOwn, [&](std::uint32_t vertex) { return patch.positionOfVertex[vertex]; });
    }

    void addTouching(const ShadedPatch& neighbour) {
        const std::vector<std::uint32_t> shared = sharedPlaces(neighbour.positions);
        const auto touches = [&](std::uint32_t vertex) {
            return shared[neighbour.positionOfVertex[vertex]] != ShadedPatch::kNotOfWall;
        };
        addTriangles(neighbour, touches, [&](std::uint32_t vertex) {
            const std::uint32_t place = neighbour.positionOfVertex[vertex];
            return shared[place] != ShadedPatch::kNotOfWall ? shared[place] : fartherVertex(neighbour.positions[place]);
        });
    }

    [[nodiscard]] CornerShading shading() const { return cornerShading(mesh_, tags_); }

private:
    /// For each of `others`, its index among the patch's own positions, or kNotOfWall. Both lists ascend.
    [[nodiscard]] std::vector<std::uint32_t> sharedPlaces(const std::vector<ShadedPatch::Position>& others) const {
        std::vector<std::uint32_t> shared(others.size(), ShadedPatch::kNotOfWall);
        std::size_t own = 0;
        for (std::size_t i = 0; i < others.size(); ++i) {
            while (own < places_.size() && places_[own] < others[i]) ++own;
            if (own < places_.size() && places_[own] == others[i]) shared[i] = static_cast<std::uint32_t>(own);
        }
        return shared;
    }

    /// Adds the wall triangles of `patch` that have a vertex for which `counts` is true. `joined` maps their vertices
    /// to vertices of the joined mesh.
    template <class Counts, class Joined>
    void addTriangles(const ShadedPatch& patch, const Counts& counts, const Joined& joined) {
        const TriangleMesh& mesh = patch.part->mesh();
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const Triangle& corners = mesh.triangles[t];
            if (patch.baseTriangles[t] || std::none_of(corners.begin(), corners.end(), counts)) continue;
            mesh_.triangles.push_back({joined(corners[0]), joined(corners[1]), joined(corners[2])});
            tags_.push_back(patch.part->tag(t));
        }
    }

    /// The joined vertex for a neighbour's vertex that the patch itself does not have.
    std::uint32_t fartherVertex(const ShadedPatch::Position& place) {
        const auto [known, isNew] = farther_.try_emplace(place, static_cast<std::uint32_t>(mesh_.vertices.size()));
        if (isNew) mesh_.vertices.emplace_back(place.data());
        return known->second;
    }

    const std::vector<ShadedPatch::Position>& places_;
    TriangleMesh mesh_;
    std::vector<SurfaceTag> tags_;
    std::map<ShadedPatch::Position, std::uint32_t> farther_;
};

/// The vertices of the wall triangles of `patch`, one for each corner.
std::vector<std::uint32_t> cornersOfWall(const ShadedPatch& patch) {
    const std::vector<Triangle>& triangles = patch.part->mesh().triangles;
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (!patch.baseTriangles[t]) corners.insert(corners.end(), triangles[t].begin(), triangles[t].end());
    }
    return corners;
}

}  // namespace

ShadedPatch::ShadedPatch(std::shared_ptr<const SurfacePart> patch, const SurfacePart& base,
                         const CornerShading& baseShading)
    : part(std::move(patch)) {
    const TriangleMesh& mesh = part->mesh();
    baseTriangles.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) baseTriangles.push_back(baseTriangle(mesh, t, base));
    const std::vector<std::uint32_t> corners = cornersOfWall(*this);
    positions.reserve(corners.size());
    for (const std::uint32_t vertex : corners) positions.push_back(placeOf(mesh.vertices[vertex]));
    std::sort(positions.begin(), positions.end());
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    positionOfVertex.assign(mesh.vertices.size(), kNotOfWall);
    for (const std::uint32_t vertex : corners) {
        if (positionOfVertex[vertex] != kNotOfWall) continue;
        const auto place = std::lower_bound(positions.begin(), positions.end(), placeOf(mesh.vertices[vertex]));
        positionOfVertex[vertex] = static_cast<std::uint32_t>(place - positions.begin());
    }
    rimAppearances.reserve(positions.size());
    for (const Position& place : positions) {
        const Vec3 point = Vec3f(place.data()).cast<double>();
        wall.extend(point);
        rimAppearances.push_back(rimAppearanceAt(base, baseShading, point));
    }
}

CornerShading patchShading(const ShadedPatch& patch, std::span<const ShadedPatch* const> neighbours,
                           const SurfacePart& base, const CornerShading& baseShading, const AppearanceZones* zones) {
    JoinedWall walls(patch);
    for (const ShadedPatch* neighbour : neighbours) walls.addTouching(*neighbour);
    const CornerShading joined = walls.shading();

    const TriangleMesh& mesh = patch.part->mesh();
    CornerShading shading{std::vector<Vec3f>(3 * mesh.triangles.size()),
                          std::vector<AppearanceMix>(3 * mesh.triangles.size())};
    std::size_t ofWall = 0;  // the wall's triangles come first in the joined mesh, in their order
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            Corner corner;
            if (const auto& carried = patch.baseTriangles[t]) {
                corner = interpolated(base.mesh(), baseShading, *carried, mesh.corner(t, static_cast<int>(c)));
            } else {
                const auto& rim = patch.rimAppearances[patch.positionOfVertex[mesh.triangles[t][c]]];
                corner = {joined.normals[3 * ofWall + c], rim.value_or(joined.appearances[3 * ofWall + c])};
                if (!rim && zones != nullptr) {
                    corner.mix =
                        zonedMix(*zones, corner.mix, {.point = mesh.corner(t, static_cast<int>(c)), .isCut = true});
                }
            }
            shading.normals[3 * t + c] = corner.normal;
            shading.appearances[3 * t + c] = corner.mix;
        }
        ofWall += patch.baseTriangles[t] ? 0 : 1;
    }
    return shading;
}

}  // namespace tactooth
