// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// Planes that bound a tool on about a hundred sides (a k-DOP), in the tool's frame: their normals are those of its
/// faces, and others spread evenly over the sphere. A point beyond one of them is outside the tool. Read-only after
/// construction.
class SupportPlanes {
public:
    explicit SupportPlanes(const TriangleMesh& mesh);

    struct Plane {
        Vec3f inward;  ///< unit normal, towards the tool
        float low;     ///< least dot product of a point of the tool with `inward`, mm
    };
    using Number = std::uint16_t;
    /// A plane and those with the most similar normals, itself first.
    static constexpr int kNeighbours = 16;
    using Neighbours = std::array<Number, kNeighbours>;

    [[nodiscard]] std::size_t size() const { return planes_.size(); }
    [[nodiscard]] const Plane& operator[](Number number) const {
        TACTOOTH_ASSERT(number < planes_.size());
        return planes_[number];
    }
    [[nodiscard]] const Neighbours& similarTo(Number number) const {
        TACTOOTH_ASSERT(number < neighbours_.size());
        return neighbours_[number];
    }
    /// The plane that a point (mm, tool's frame) is furthest beyond; not for a tool without triangles.
    [[nodiscard]] Number facing(const Vec3f& point) const;

    /// For each plane, by how much `low` may fall if the tool rotates about its origin by up to `turn` (a chord): mm
    /// per chord.
    [[nodiscard]] std::span<const float> losses(double turn) const;

    /// The support plane with any unit normal, and by how much a rotation by up to `turn` (a chord) lowers it, mm per
    /// chord.
    struct Reach {
        Plane plane;
        float loss;
    };
    [[nodiscard]] Reach across(const Vec3f& inward, float turn) const;

private:
    /// Eight vertices of the tool.
    struct alignas(32) PointPacket {
        float at[3][8];
        float far[8];  ///< distance from the origin, rounded up, mm
    };
    void keepPoints(const TriangleMesh& mesh);
    [[nodiscard]] float lowAfter(double turn, const Vec3f& inward) const;
    void measure();
    void findNeighbours();

    static constexpr std::array<double, 3> kChords = {0.008, 0.032, 2};  // chords; the last is half a turn
    std::vector<PointPacket> points_;
    std::vector<Plane> planes_;
    std::vector<Neighbours> neighbours_;
    std::array<std::vector<float>, kChords.size()> losses_;
};

}  // namespace tactooth
