// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/triangle_boxes.h"

#include <algorithm>
#include <utility>

namespace tactooth {

TriangleBoxes::TriangleBoxes(const TriangleMesh& mesh, std::vector<std::uint32_t> triangles)
    : triangles_(std::move(triangles)), boxes_((triangles_.size() + 7) / 8) {
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[triangles_[i]];
        const Vec3f low = mesh.vertices[a].cwiseMin(mesh.vertices[b]).cwiseMin(mesh.vertices[c]);
        const Vec3f high = mesh.vertices[a].cwiseMax(mesh.vertices[b]).cwiseMax(mesh.vertices[c]);
        put(i, triangles_[i], low, high);
    }
    resize(triangles_.size());
}

void TriangleBoxes::add(std::uint32_t triangle, const Vec3f& low, const Vec3f& high) {
    resize(triangles_.size() + 1);
    put(triangles_.size() - 1, triangle, low, high);
}

void TriangleBoxes::put(std::size_t place, std::uint32_t triangle, const Vec3f& low, const Vec3f& high) {
    triangles_[place] = triangle;
    for (int axis = 0; axis < 3; ++axis) {
        boxes_[place / 8].low[axis][place % 8] = low[axis];
        boxes_[place / 8].high[axis][place % 8] = high[axis];
    }
}

void TriangleBoxes::resize(std::size_t count) {
    triangles_.resize(count);
    boxes_.resize((count + 7) / 8);
    for (std::size_t absent = count; absent < 8 * boxes_.size(); ++absent) {
        for (int axis = 0; axis < 3; ++axis) {
            boxes_[absent / 8].low[axis][absent % 8] = std::numeric_limits<float>::infinity();
            boxes_[absent / 8].high[axis][absent % 8] = -std::numeric_limits<float>::infinity();
        }
    }
}

}  // namespace tactooth
