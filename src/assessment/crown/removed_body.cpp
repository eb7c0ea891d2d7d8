// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/removed_body.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr int kNodesAside = kBrickSide + 1;  // of a brick, with the first ones of the bricks after it

/// Fills the cut fields of one lattice.
class FieldMaker {
public:
    FieldMaker(const RemovedBody& body, const SurfacePart& outer, const Lattice& lattice)
        : body_(body), outer_(outer), lattice_(lattice), band_(kCutBand * lattice.spacing()) {}

    /// Null: the body, or the tooth, is clear of the brick.
    [[nodiscard]] std::unique_ptr<CutField> fieldOf(const BrickKey& key) const {
        const Vec3 centre = lattice_.centre(key);
        const double reach = lattice_.halfDiagonal() + 2 * lattice_.spacing();
        const double deep = body_.depthAt(centre).value;
        if (deep < -RemovedBody::kSteepest * reach - band_) return nullptr;
        if (signedDistance(outer_, centre) > reach) return nullptr;
        auto field = std::make_unique<CutField>(CutField::untouched(lattice_.spacing()));
        field->isCut = true;
        if (deep > RemovedBody::kSteepest * reach + band_) {
            field->cut.fill(static_cast<float>(-band_));
        } else {
            measure(key, *field);
        }
        return field;
    }

private:
    void measure(const BrickKey& key, CutField& field) const {
        std::array<float, static_cast<std::size_t>(kNodesAside * kNodesAside * kNodesAside)> distances{};
        const auto at = [](int x, int y, int z) {
            return static_cast<std::size_t>(x + kNodesAside * (y + kNodesAside * z));
        };
        for (int z = 0; z < kNodesAside; ++z) {
            for (int y = 0; y < kNodesAside; ++y) {
                for (int x = 0; x < kNodesAside; ++x) {
                    const auto [value, gradient] = body_.depthAt(lattice_.node(key, {x, y, z}));
                    distances[at(x, y, z)] = static_cast<float>(std::clamp(-value, -band_, band_));
                    if (std::max({x, y, z}) == kBrickSide) continue;
                    const auto node = static_cast<std::size_t>(nodeIndex(x, y, z));
                    field.cut[node] = distances[at(x, y, z)];
                    field.cutNormal[node] = OctahedralNormal(-gradient.normalized());
                }
            }
        }
        for (int node = 0; node < kBrickNodes; ++node) {
            const auto [x, y, z] = placeOf(node);
            const float here = distances[at(x, y, z)];
            for (int axis = 0; axis < 3; ++axis) {
                const std::array<int, 3> next = {x + (axis == 0), y + (axis == 1), z + (axis == 2)};
                const float there = distances[at(next[0], next[1], next[2])];
                if ((here < 0) == (there < 0)) continue;
                field.boundary[static_cast<std::size_t>(axis)][static_cast<std::size_t>(node)] =
                    crossing(lattice_.node(key, {x, y, z}), lattice_.node(key, next), here < 0);
            }
        }
    }

    /// Where the boundary crosses an edge, by halving.
    [[nodiscard]] HermiteSample crossing(const Vec3& from, const Vec3& to, bool startsRemoved) const {
        constexpr int kHalvings = 7;  // to less than a micrometre
        double low = 0, high = 1;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = (low + high) / 2;
            const bool isRemoved = body_.depthAt(from + middle * (to - from)).value > 0;
            (isRemoved == startsRemoved ? low : high) = middle;
        }
        const double place = (low + high) / 2;
        const Vec3 gradient = body_.depthAt(from + place * (to - from)).gradient;
        return {static_cast<float>(place), OctahedralNormal(-gradient.normalized())};
    }

    const RemovedBody& body_;
    const SurfacePart& outer_;
    Lattice lattice_;
    double band_;
};

}  // namespace

RemovedBody::Depth unitedRound(const RemovedBody::Depth& a, const RemovedBody::Depth& b, double wanted) {
    // What stands is widened by a ball that has first been taken off: beside the edge of the narrower rest, the
    // boundary is a cylinder round that edge.
    const double cosine = a.gradient.stableNormalized().dot(b.gradient.stableNormalized());
    const double radius = wanted * std::min(1.0, 1 + cosine);
    const double u = a.value + radius, v = b.value + radius;
    constexpr double kOnePlane = 1e-6;  // of the squared sine
    const double squaredSine = 1 - cosine * cosine;
    if (radius > 0 && u > cosine * v && v > cosine * u && squaredSine > kOnePlane) {
        const double distance = std::sqrt((u * u + v * v - 2 * cosine * u * v) / squaredSine);
        const Vec3 gradient = (u - cosine * v) * a.gradient.normalized() + (v - cosine * u) * b.gradient.normalized();
        if (distance > 0) return {distance - radius, gradient / (distance * squaredSine)};
    }
    return b.value > a.value ? b : a;
}

std::map<BrickKey, CutField> cutFieldsOf(const RemovedBody& body, const SurfacePart& outer, const Lattice& lattice) {
    const FieldMaker maker(body, outer, lattice);
    const std::vector<BrickKey> keys = lattice.bricksTouching(body.box());
    std::vector<std::unique_ptr<CutField>> made(keys.size());
    parallelFor(keys.size(), [&](std::size_t i) { made[i] = maker.fieldOf(keys[i]); });
    std::map<BrickKey, CutField> fields;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (made[i] != nullptr) fields.emplace(keys[i], *made[i]);
    }
    return fields;
}

}  // namespace tactooth
