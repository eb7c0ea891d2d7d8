// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "collision/narrow/simd8.h"
#include "geometry/util/assert.h"
#include "geometry/util/vec.h"
#include "tooth/model/material.h"

namespace tactooth {

/// A unit direction in four bytes, exact to 6e-5 rad: octahedral encoding (Z. Cigolle et al., "A Survey of Efficient
/// Representations for Independent Unit Vectors", JCGT 2014). The direction is finite; it need not have unit length.
class OctahedralNormal {
public:
    OctahedralNormal() = default;
    explicit OctahedralNormal(const Vec3& direction) {
        TACTOOTH_ASSERT(direction.allFinite());
        const double sum = direction.cwiseAbs().sum();
        if (sum == 0) return;
        double u = direction.x() / sum;
        double v = direction.y() / sum;
        if (direction.z() < 0) {
            const double folded = (1 - std::abs(v)) * (u >= 0 ? 1 : -1);
            v = (1 - std::abs(u)) * (v >= 0 ? 1 : -1);
            u = folded;
        }
        u_ = rounded(u * kScale);
        v_ = rounded(v * kScale);
    }
    /// Packs eight directions of about unit length, in single precision.
    [[nodiscard]] static std::array<OctahedralNormal, 8> pack(const Vec3x8& directions) {
        const Float8 zero = Float8::all(0);
        const Float8 one = Float8::all(1);
        const auto sizeOf = [&](Float8 value) { return max(value, zero - value); };
        const auto signOf = [&](Float8 value) { return whereLess(value, zero, zero - one, one); };
        const Float8 sum = max(sizeOf(directions.x) + sizeOf(directions.y) + sizeOf(directions.z), Float8::all(1e-18F));
        const Float8 u = directions.x / sum;
        const Float8 v = directions.y / sum;
        const Float8 scale = Float8::all(static_cast<float>(kScale));
        float us[8], vs[8];
        (scale * whereLess(directions.z, zero, (one - sizeOf(v)) * signOf(u), u)).store(us);
        (scale * whereLess(directions.z, zero, (one - sizeOf(u)) * signOf(v), v)).store(vs);
        std::array<OctahedralNormal, 8> packed;
        for (int lane = 0; lane < 8; ++lane) {
            packed[lane].u_ = rounded(us[lane]);
            packed[lane].v_ = rounded(vs[lane]);
        }
        return packed;
    }
    [[nodiscard]] Vec3 unpack() const { return unpackAs<double>(); }
    /// In single precision.
    [[nodiscard]] Vec3f unpackSingle() const { return unpackAs<float>(); }
    /// Unpacks eight at once. Returns the same bits as `unpackSingle`.
    [[nodiscard]] static Vec3x8 unpack(const std::array<OctahedralNormal, 8>& directions) {
        static_assert(sizeof(directions) == 16 * sizeof(std::int16_t));
        const auto [us, vs] = Float8::loadPairs(&directions[0].u_);
        const Float8 zero = Float8::all(0);
        const Float8 one = Float8::all(1);
        const auto sizeOf = [&](Float8 value) { return max(value, zero - value); };
        const auto signOf = [&](Float8 value) { return whereLess(value, zero, zero - one, one); };
        const Float8 scale = Float8::all(static_cast<float>(kScale));
        const Float8 u = us / scale;
        const Float8 v = vs / scale;
        const Float8 z = one - sizeOf(u) - sizeOf(v);
        const Float8 x = whereLess(z, zero, (one - sizeOf(v)) * signOf(u), u);
        const Float8 y = whereLess(z, zero, (one - sizeOf(u)) * signOf(v), v);
        const Float8 length = sqrt(x * x + y * y + z * z);
        return {x / length, y / length, z / length};
    }
    /// Absolute components of four at once. Returns the same bits as `unpack`.
    [[nodiscard]] static std::array<Eigen::Array4d, 3> absComponentsOf(
        const std::array<OctahedralNormal, 4>& directions) {
        Eigen::Array4d u, v;
        for (int i = 0; i < 4; ++i) {
            u[i] = std::abs(static_cast<int>(directions[i].u_));
            v[i] = std::abs(static_cast<int>(directions[i].v_));
        }
        u /= kScale;
        v /= kScale;
        const Eigen::Array4d z = 1 - u - v;
        const Eigen::Array4d x = (z < 0).select(1 - v, u);
        const Eigen::Array4d y = (z < 0).select(1 - u, v);
        const Eigen::Array4d length = (x * x + y * y + z * z).sqrt();
        return {x / length, y / length, z.abs() / length};
    }
    friend bool operator==(const OctahedralNormal&, const OctahedralNormal&) = default;

private:
    template <class Real>
    [[nodiscard]] Eigen::Matrix<Real, 3, 1> unpackAs() const {
        Real u = u_ / static_cast<Real>(kScale);
        Real v = v_ / static_cast<Real>(kScale);
        const Real z = 1 - std::abs(u) - std::abs(v);
        if (z < 0) {
            const Real unfolded = (1 - std::abs(v)) * (u >= 0 ? 1 : -1);
            v = (1 - std::abs(u)) * (v >= 0 ? 1 : -1);
            u = unfolded;
        }
        return Eigen::Matrix<Real, 3, 1>(u, v, z) /
               std::sqrt(u * u + v * v + z * z);  // the same order of additions as in `absComponentsOf`
    }

    static constexpr double kScale = 32767.0;
    /// std::lround without a function call. `value` is at most kScale in size.
    template <class Real>
    static std::int16_t rounded(Real value) {
        TACTOOTH_ASSERT(value >= -static_cast<Real>(kScale) && value <= static_cast<Real>(kScale));
        const Real half = static_cast<Real>(0.5);
        return static_cast<std::int16_t>(value + (value < 0 ? -half : half));
    }
    std::int16_t u_ = 0;
    std::int16_t v_ = 0;
};

/// Nodes along one side of a brick.
inline constexpr int kBrickSide = 8;
inline constexpr int kBrickNodes = kBrickSide * kBrickSide * kBrickSide;

[[nodiscard]] constexpr int nodeIndex(int x, int y, int z) {
    TACTOOTH_ASSERT(x >= 0 && x < kBrickSide);
    TACTOOTH_ASSERT(y >= 0 && y < kBrickSide);
    TACTOOTH_ASSERT(z >= 0 && z < kBrickSide);
    return x + kBrickSide * (y + kBrickSide * z);
}
/// Position of a node in its brick, 0..7 on each axis.
[[nodiscard]] constexpr std::array<int, 3> placeOf(int node) {
    TACTOOTH_ASSERT(node >= 0 && node < kBrickNodes);
    return {node % kBrickSide, node / kBrickSide % kBrickSide, node / (kBrickSide * kBrickSide)};
}
/// Step from a node's index to that of the next node on an axis.
[[nodiscard]] constexpr int nodeStride(int axis) {
    TACTOOTH_ASSERT(axis >= 0 && axis < 3);
    return nodeIndex(axis == 0, axis == 1, axis == 2);
}

/// A set of nodes of a brick, one bit for each in the order of nodeIndex. Each word is a layer of constant z.
class NodeBits {
public:
    static constexpr std::uint64_t kFirstColumn = 0x0101010101010101;  ///< the nodes of a layer at x = 0 ...
    static constexpr std::uint64_t kFirstRow = 0xFF;                   ///< ... and those at y = 0

    void set(int node) {
        TACTOOTH_ASSERT(node >= 0 && node < kBrickNodes);
        layers_[node / 64] |= std::uint64_t{1} << node % 64;
    }
    void reset() { layers_.fill(0); }
    [[nodiscard]] bool operator[](int node) const {
        TACTOOTH_ASSERT(node >= 0 && node < kBrickNodes);
        return (layers_[node / 64] >> node % 64 & 1) != 0;
    }
    [[nodiscard]] std::uint64_t layer(int z) const {
        TACTOOTH_ASSERT(z >= 0 && z < kBrickSide);
        return layers_[z];
    }
    [[nodiscard]] unsigned row(int y, int z) const {
        TACTOOTH_ASSERT(y >= 0 && y < kBrickSide);
        TACTOOTH_ASSERT(z >= 0 && z < kBrickSide);
        return layers_[z] >> kBrickSide * y & kFirstRow;
    }
    void setRow(int y, int z, std::uint64_t bits) {
        TACTOOTH_ASSERT(y >= 0 && y < kBrickSide);
        TACTOOTH_ASSERT(z >= 0 && z < kBrickSide);
        TACTOOTH_ASSERT(bits <= kFirstRow);
        layers_[z] = (layers_[z] & ~(kFirstRow << kBrickSide * y)) | bits << kBrickSide * y;
    }

private:
    std::array<std::uint64_t, kBrickSide> layers_{};
};

/// Half width of the narrow bands of the two distance fields, in voxels; larger distances are clamped. Cut field: two
/// neighbouring nodes on different sides of the boundary lie within 1 of it, and dual contouring needs both distances;
/// the count of volumes needs less. A wider band would cost time, since each move updates more nodes. Tooth field: wide
/// enough to prove that a wall does not meet the tooth's surface.
inline constexpr double kCutBand = 1.25;
inline constexpr double kToothBand = 4.0;

/// Where the boundary of the removed region crosses a lattice edge: 0 at the first node, 1 at the next. With the normal
/// there, out of the removed region.
struct HermiteSample {
    float place = 0;
    OctahedralNormal normal;
};

/// The part of a brick that cutting changes.
struct CutField {
    std::array<float, kBrickNodes> cut;  ///< signed distance to the removed region, mm, negative inside
    std::array<OctahedralNormal, kBrickNodes> cutNormal;  ///< gradient of `cut`, out of the removed region

    /// For the lattice edge from each node to the next one on each axis. Valid if exactly one of the two nodes is
    /// removed.
    std::array<std::array<HermiteSample, kBrickNodes>, 3> boundary;

    bool isCut = false;  ///< a sweep has reached some node

    /// The field of a brick that no bur has reached. `spacing` in mm.
    static CutField untouched(double spacing) {
        TACTOOTH_ASSERT(std::isfinite(spacing) && spacing > 0);
        CutField field;
        field.cut.fill(static_cast<float>(kCutBand * spacing));
        field.cutNormal.fill(OctahedralNormal(Vec3::UnitZ()));
        for (auto& crossings : field.boundary) crossings.fill({});
        return field;
    }

    /// Asserts that the distances are within their band, that crossings lie on their edges, and that a field without a
    /// cut is untouched. Looks at every node. `spacing` in mm.
    void validate(double spacing) const;
};

/// 8 x 8 x 8 nodes of two distance fields. The solid is where `tooth < 0` and `cut > 0`.
struct Brick : CutField {
    std::array<float, kBrickNodes> tooth;  ///< signed distance to the tooth's own surface, mm, negative inside
    float maxToothDistance = kUnknown;     ///< the maximum of `tooth`
    std::array<OctahedralNormal, kBrickNodes> toothNormal;  ///< gradient of `tooth`, out of the tooth
    std::array<MaterialId, kBrickNodes> material;
    std::array<MaterialId, kBrickNodes> neighbour;  ///< second material in the voxel, beyond a layer's surface
    std::array<std::uint8_t, kBrickNodes> neighbourFraction;  ///< its volume fraction, in 255ths

    NodeBits removed;  ///< nodes where `cut < 0`

    static constexpr float kUnknown = std::numeric_limits<float>::infinity();

    std::uint64_t lastCarve = 0;  ///< number of the carve that the next two sets belong to
    NodeBits lowered;             ///< nodes whose `cut` this carve has changed
    NodeBits opened;              ///< nodes that it has removed

    /// The removed nodes of a row along x, one bit each.
    [[nodiscard]] unsigned removedRow(int y, int z) const { return removed.row(y, z); }
    void setRemoved(int node) { removed.set(node); }
    /// Replaces the cut field, and the bits of the removed nodes with it.
    void setField(const CutField& field) {
        static_cast<CutField&>(*this) = field;
        for (int row = 0; row < kBrickNodes / kBrickSide; ++row) {
            const Float8 distances = Float8::load(&cut[kBrickSide * row]);
            removed.setRow(row % kBrickSide, row / kBrickSide, ~lessEqual(Float8::all(0), distances) & 0xFF);
        }
    }
    /// Asserts the invariants of the brick: its cut field, the bits of the removed nodes, the distances to the tooth
    /// and their maximum. Looks at every node. `spacing` in mm.
    void validate(double spacing) const;
};

}  // namespace tactooth
