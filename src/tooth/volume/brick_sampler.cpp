// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/brick_sampler.h"

#include <cmath>
#include <limits>

#include "collision/bvh/closest_point.h"
#include "collision/narrow/triangle_point.h"
#include "geometry/util/assert.h"
#include "tooth/model/leaf_cache.h"
#include "tooth/volume/voxel_fraction.h"

// Own method. The exact distances come from nearest-point queries to the triangles near the brick (LeafCache). The
// normal of the nearest face or the neighbouring node gives the sign; a ray test decides the rest.

namespace tactooth {
namespace {

/// Voxels. A brick whose nodes are all farther outside the tooth is absent. A wall triangle that is kept starts at a
/// node within 2.2, and its vertices use crossings of cells that reach sqrt(3) farther.
constexpr double kAirMargin = 3.95;
/// Voxels. Band of a layer's distance: wide enough to find the nearest layer beside a narrow gap.
constexpr double kLayerBand = 2.0;
/// If the cosine between the offset from the nearest point and the normal of its face exceeds this, the normal decides
/// the side.
constexpr double kAlongNormal = 1 - 1e-7;
/// mm; a shorter offset from the surface has no direction.
constexpr double kOnSurface = 1e-6;

struct SignedField {
    std::array<float, kBrickNodes> distance;
    std::array<OctahedralNormal, kBrickNodes> gradient;
    bool uniform = false;  ///< the surface is beyond the band at every node
};

/// Computes the signed distances at the nodes of one brick. It visits the nodes so that each one is next to the one
/// before. If two distances sum to more than the step between their nodes, both nodes are on the same side. This saves
/// most inside tests.
class SignedSampler {
public:
    /// `signFromNormals`: the surface is a solid whose normals all point outward. Else a ray test decides each side.
    SignedSampler(const SurfacePart& part, const Lattice& lattice, const BrickKey& key, double band,
                  bool signFromNormals)
        : part_(part),
          signFromNormals_(signFromNormals),
          near_(part, lattice.centre(key), lattice.halfDiagonal() + band),
          corner_(lattice.corner(key)),
          spacing_(lattice.spacing()),
          band_(band) {
        TACTOOTH_ASSERT(std::isfinite(band) && band > 0);
        const Vec3 centre = lattice.centre(key);
        field_.uniform = near_.empty();
        if (field_.uniform) {
            field_.distance.fill(static_cast<float>(isInside(centre) ? -band : band));
            field_.gradient.fill(OctahedralNormal(Vec3::UnitZ()));
        } else {
            walk();
        }
    }
    [[nodiscard]] const SignedField& field() const { return field_; }

private:
    [[nodiscard]] bool isInside(const Vec3& point) const {
        return part_.tree().box().contains(point) && contains(part_, point);
    }

    void walk() {
        bool forwardX = true;
        bool forwardY = true;
        for (int z = 0; z < kBrickSide; ++z, forwardY = !forwardY) {
            for (int row = 0; row < kBrickSide; ++row, forwardX = !forwardX) {
                const int y = forwardY ? row : kBrickSide - 1 - row;
                for (int column = 0; column < kBrickSide; ++column) {
                    visit(forwardX ? column : kBrickSide - 1 - column, y, z);
                }
            }
        }
    }

    void visit(int x, int y, int z) {
        const Vec3 point = corner_ + spacing_ * Vec3(x, y, z);
        const auto hit = near_.closest(point, reachAt(point));
        const double distance = hit ? std::min(hit->distance, band_) : band_;
        TACTOOTH_ASSERT(distance >= 0 && distance <= band_);
        const Vec3 away = hit ? Vec3(point - hit->point) : Vec3::UnitZ();
        if (previous_ + distance <= spacing_ * (1 + 1e-6) || first_) inside_ = isInsideNear(point, away, hit);
        first_ = false;
        previous_ = distance;
        if (hit) nearest_ = hit->triangle;
        const int node = nodeIndex(x, y, z);
        field_.distance[node] = static_cast<float>(inside_ ? -distance : distance);
        field_.gradient[node] = OctahedralNormal(inside_ ? Vec3(-away) : away);
    }

    /// The triangle nearest to the node before gives an upper bound at this node.
    [[nodiscard]] double reachAt(const Vec3& point) {
        if (!nearest_) return std::min(band_, previous_ + spacing_ * (1 + 1e-6));
        const TriangleMesh& mesh = part_.mesh();
        TACTOOTH_ASSERT(*nearest_ < mesh.triangles.size());
        const Vec3 there =
            closestOnTriangle(point, mesh.corner(*nearest_, 0), mesh.corner(*nearest_, 1), mesh.corner(*nearest_, 2));
        return std::min(band_, (there - point).norm() * (1 + 1e-12));
    }

    [[nodiscard]] bool isInsideNear(const Vec3& point, const Vec3& away, const std::optional<ClosestPoint>& hit) const {
        if (signFromNormals_ && hit && hit->distance > kOnSurface) {
            const double cosine = part_.mesh().areaVector(hit->triangle).normalized().dot(away) / hit->distance;
            if (std::abs(cosine) > kAlongNormal) return cosine < 0;
        }
        return isInside(point);
    }

    const SurfacePart& part_;
    const bool signFromNormals_;
    const LeafCache near_;
    const Vec3 corner_;
    const double spacing_;
    const double band_;
    SignedField field_;
    bool first_ = true;
    bool inside_ = false;
    double previous_ = std::numeric_limits<double>::infinity();
    std::optional<std::uint32_t> nearest_;  // triangle nearest to the node before
};

/// A layer whose border runs through a node's voxel leaves a part of the voxel to the material without the layer.
void shareVoxel(Brick& brick, int node, MaterialId layer, const SignedField& field, double spacing) {
    const double distance = field.distance[node];
    const double within = cubeFraction({distance / spacing, field.gradient[node].unpack()});
    TACTOOTH_ASSERT(within >= 0 && within <= 1);
    if (within == 0) return;
    brick.neighbour[node] = distance < 0 ? brick.material[node] : layer;
    brick.neighbourFraction[node] = static_cast<std::uint8_t>(std::lround(255 * (distance < 0 ? 1 - within : within)));
}

void fillMaterials(Brick& brick, const LayeredTooth& tooth, const Lattice& lattice, const BrickKey& key) {
    brick.material.fill(tooth.body());
    brick.neighbour.fill(tooth.body());
    brick.neighbourFraction.fill(0);
    if (tooth.layers().empty()) return;
    const double band = kLayerBand * lattice.spacing();
    const auto bandFloat = static_cast<float>(band);
    std::array<float, kBrickNodes> nearest;
    nearest.fill(bandFloat);
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        const SignedSampler sampler(*layer.part, lattice, key, band, true);
        for (int node = 0; node < kBrickNodes; ++node) {
            const float distance = sampler.field().distance[node];
            if (nearest[node] < bandFloat) shareVoxel(brick, node, layer.material, sampler.field(), lattice.spacing());
            if (distance >= 0 && distance >= nearest[node]) continue;
            brick.material[node] = layer.material;
            nearest[node] = distance < 0 ? 0 : distance;
        }
    }
    for (int node = 0; node < kBrickNodes; ++node) {
        if (nearest[node] < bandFloat || brick.tooth[node] > bandFloat) continue;
        const auto [x, y, z] = placeOf(node);
        brick.material[node] = tooth.materialAt(lattice.corner(key) + lattice.spacing() * Vec3(x, y, z));
    }
}

}  // namespace

std::unique_ptr<Brick> sampleBrick(const LayeredTooth& tooth, const Lattice& lattice, const BrickKey& key) {
    TACTOOTH_ASSERT(key.isInRange());
    const double spacing = lattice.spacing();
    const SignedSampler outer(*tooth.outer(), lattice, key, kToothBand * spacing, !tooth.bodiesOverlap());
    const auto& distance = outer.field().distance;
    const bool isAir = std::all_of(distance.begin(), distance.end(),
                                   [&](float d) { return d > static_cast<float>(kAirMargin * spacing); });
    if (isAir) return nullptr;
    auto brick = std::make_unique<Brick>();
    brick->setField(CutField::untouched(spacing));
    brick->tooth = distance;
    brick->maxToothDistance = *std::max_element(distance.begin(), distance.end());
    TACTOOTH_ASSERT(std::abs(brick->maxToothDistance) <= static_cast<float>(kToothBand * spacing));
    brick->toothNormal = outer.field().gradient;
    fillMaterials(*brick, tooth, lattice, key);
    return brick;
}

}  // namespace tactooth
