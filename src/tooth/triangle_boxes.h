// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision/simd8.h"
#include "geometry/triangle_mesh.h"

namespace tactooth {

/// Some triangles of a mesh with their boxes, to be asked again and again which of them may touch another one.
class TriangleBoxes {
public:
    TriangleBoxes() = default;
    TriangleBoxes(const TriangleMesh& mesh, std::vector<std::uint32_t> triangles);

    void add(std::uint32_t triangle, const Vec3f& low, const Vec3f& high);

    [[nodiscard]] const std::vector<std::uint32_t>& triangles() const { return triangles_; }
    [[nodiscard]] bool empty() const { return triangles_.empty(); }

    /// Calls `visit(triangle)` for each one whose box touches that of a triangle with these corners, in their order.
    template <class Visit>
    void forTouching(const std::array<Vec3f, 3>& corners, const Visit& visit) const {
        const Vec3f low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
        const Vec3f high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
        for (std::size_t group = 0; group < boxes_.size(); ++group) {
            std::uint32_t touching = 0xFF;
            for (int axis = 0; axis < 3 && touching != 0; ++axis) {
                touching &= lessEqual(Float8::load(boxes_[group].low[axis]), Float8::all(high[axis])) &
                            lessEqual(Float8::all(low[axis]), Float8::load(boxes_[group].high[axis]));
            }
            for (; touching != 0; touching &= touching - 1) {
                visit(triangles_[8 * group + static_cast<std::size_t>(std::countr_zero(touching))]);
            }
        }
    }

    /// Calls `visit(triangle, low, high)` for each one in their order, and forgets those for which it says so.
    template <class Visit>
    void forgetIf(const Visit& visit) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            Vec3f low, high;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = boxes_[i / 8].low[axis][i % 8];
                high[axis] = boxes_[i / 8].high[axis][i % 8];
            }
            if (!visit(triangles_[i], low, high)) put(kept++, triangles_[i], low, high);
        }
        resize(kept);
    }

private:
    void put(std::size_t place, std::uint32_t triangle, const Vec3f& low, const Vec3f& high);
    void resize(std::size_t count);

    /// Of eight triangles; those that are not there touch nothing.
    struct alignas(32) Eight {
        float low[3][8];
        float high[3][8];
    };
    std::vector<std::uint32_t> triangles_;
    std::vector<Eight> boxes_;
};

}  // namespace tactooth
