// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// How far a tool reaches along some hundred directions: those across its faces, and others evenly all around. What
/// lies beyond one of these sides is parted from the whole tool. Read-only after construction.
class SupportPlanes {
public:
    explicit SupportPlanes(const TriangleMesh& mesh);

    struct Plane {
        Vec3f inward;  ///< unit
        float low;     ///< the least dot product of a point of the tool with it, mm
    };
    using Number = std::uint16_t;
    /// A side and those beside it.
    static constexpr int kNeighbours = 16;
    using Neighbours = std::array<Number, kNeighbours>;

    [[nodiscard]] std::size_t size() const { return planes_.size(); }
    [[nodiscard]] const Plane& operator[](Number side) const { return planes_[side]; }
    [[nodiscard]] const Neighbours& beside(Number side) const { return neighbours_[side]; }
    /// The side beyond which a point lies the furthest.
    [[nodiscard]] Number facing(const Vec3f& point) const;

    /// What a turn about the origin by up to a chord makes of `low`, per chord, at most: the losses of all sides.
    [[nodiscard]] std::span<const float> losses(double turn) const;

    /// The side that looks along any unit direction, and its loss with a turn by a chord, per chord.
    struct Reach {
        Plane side;
        float loss;
    };
    [[nodiscard]] Reach across(const Vec3f& inward, float turn) const;

private:
    /// The tool's corners.
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
