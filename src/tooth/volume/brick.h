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

/// A unit direction in four bytes, to 6e-5 rad: the octahedron map (Z. Cigolle et al., "A Survey of Efficient
/// Representations for Independent Unit Vectors", JCGT 2014).
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
    /// Eight directions of length 1 or almost, from single precision.
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
    /// Eight at once: the same numbers as those of `unpackSingle`.
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
    /// The sizes of the components of four at once: the same numbers as those of `unpack`.
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
        return Eigen::Matrix<Real, 3, 1>(u, v, z) / std::sqrt(u * u + v * v + z * z);  // as `absComponentsOf` adds
    }

    static constexpr double kScale = 32767.0;
    /// std::lround, without a call.
    template <class Real>
    static std::int16_t rounded(Real value) {
        TACTOOTH_ASSERT(value >= -static_cast<Real>(kScale) && value <= static_cast<Real>(kScale));
        const Real half = static_cast<Real>(0.5);
        return static_cast<std::int16_t>(value + (value < 0 ? -half : half));
    }
    std::int16_t u_ = 0;
    std::int16_t v_ = 0;
};

/// Nodes of the lattice along one side of a brick.
inline constexpr int kBrickSide = 8;
inline constexpr int kBrickNodes = kBrickSide * kBrickSide * kBrickSide;

[[nodiscard]] constexpr int nodeIndex(int x, int y, int z) {
    TACTOOTH_ASSERT(x >= 0 && x < kBrickSide);
    TACTOOTH_ASSERT(y >= 0 && y < kBrickSide);
    TACTOOTH_ASSERT(z >= 0 && z < kBrickSide);
    return x + kBrickSide * (y + kBrickSide * z);
}
/// The place of a node in its brick, 0..7 on each axis.
[[nodiscard]] constexpr std::array<int, 3> placeOf(int node) {
    TACTOOTH_ASSERT(node >= 0 && node < kBrickNodes);
    return {node % kBrickSide, node / kBrickSide % kBrickSide, node / (kBrickSide * kBrickSide)};
}
/// From a node's index to that of the next one on an axis.
[[nodiscard]] constexpr int nodeStride(int axis) {
    TACTOOTH_ASSERT(axis >= 0 && axis < 3);
    return nodeIndex(axis == 0, axis == 1, axis == 2);
}

/// Some nodes of a brick, one bit each in the order of nodeIndex: a word for each layer of constant z.
class NodeBits {
public:
    static constexpr std::uint64_t kFirstColumn = 0x0101010101010101;  ///< of a layer: the nodes at x = 0 ...
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

/// How far the two distances of a node are kept, in voxels; farther values are clamped. Removed region: a node next to
/// one across the border lies within 1 of it and must be known to have been reached, and the accounting needs less;
/// what every move must look at anew grows with this. Tooth: far enough that what lies clear of the surface is known to
/// do so.
inline constexpr double kCutBand = 1.25;
inline constexpr double kToothBand = 4.0;

/// Where the border of the removed region crosses a lattice edge: 0 at its first node, 1 at the next.
struct HermiteSample {
    float place = 0;
    OctahedralNormal normal;
};

/// What burs have done to one brick: the part of it that changes.
struct CutField {
    std::array<float, kBrickNodes> cut;                   ///< to the region that burs have swept, mm, negative inside
    std::array<OctahedralNormal, kBrickNodes> cutNormal;  ///< gradient of `cut`, out of the removed region

    /// For the lattice edge from each node to the next one on each axis, if just one of the two is removed.
    std::array<std::array<HermiteSample, kBrickNodes>, 3> boundary;

    bool isCut = false;  ///< some node has been reached by a sweep

    /// As long as no bur has come near.
    static CutField untouched(double spacing) {
        TACTOOTH_ASSERT(std::isfinite(spacing) && spacing > 0);
        CutField field;
        field.cut.fill(static_cast<float>(kCutBand * spacing));
        field.cutNormal.fill(OctahedralNormal(Vec3::UnitZ()));
        for (auto& crossings : field.boundary) crossings.fill({});
        return field;
    }

    /// Asserts that the distances keep to their band, that the boundary crosses edges within them, and that a field
    /// that is not cut is untouched. Looks at every node.
    void validate(double spacing) const;
};

/// 8x8x8 nodes of the two distance fields that make a cut tooth: the solid is where `tooth < 0` and `cut > 0`.
struct Brick : CutField {
    std::array<float, kBrickNodes> tooth;                   ///< to the tooth's own surface, mm, negative inside
    float maxToothDistance = kUnknown;                      ///< the greatest of `tooth`
    std::array<OctahedralNormal, kBrickNodes> toothNormal;  ///< gradient of `tooth`, out of the tooth
    std::array<MaterialId, kBrickNodes> material;
    std::array<MaterialId, kBrickNodes> neighbour;  ///< the material beyond a layer's border in the node's voxel
    std::array<std::uint8_t, kBrickNodes> neighbourFraction;  ///< its share of the voxel, in 255ths

    NodeBits removed;  ///< nodes where `cut < 0`

    static constexpr float kUnknown = std::numeric_limits<float>::infinity();

    std::uint64_t lastCarve = 0;  ///< number of the carve that the two sets below belong to
    NodeBits lowered;             ///< nodes whose `cut` that carve has changed
    NodeBits opened;              ///< nodes that it has removed

    /// Which of the eight nodes of a row along x are removed, one bit each.
    [[nodiscard]] unsigned removedRow(int y, int z) const { return removed.row(y, z); }
    void setRemoved(int node) { removed.set(node); }
    /// Takes over another state of the field.
    void setField(const CutField& field) {
        static_cast<CutField&>(*this) = field;
        for (int row = 0; row < kBrickNodes / kBrickSide; ++row) {
            const Float8 distances = Float8::load(&cut[kBrickSide * row]);
            removed.setRow(row % kBrickSide, row / kBrickSide, ~lessEqual(Float8::all(0), distances) & 0xFF);
        }
    }
    /// Asserts the invariants of the brick: those of its cut field, the bits of the removed nodes, the distances to the
    /// tooth and the shares of neighbouring materials. Looks at every node.
    void validate(double spacing) const;
};

}  // namespace tactooth
