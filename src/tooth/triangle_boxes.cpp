// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/triangle_boxes.h"

#include <algorithm>
#include <utility>

namespace tactooth {

TriangleBoxes::TriangleBoxes(const TriangleMesh& mesh, std::vector<std::uint32_t> triangles)
    : triangles_(std::move(triangles)), boxes_((triangles_.size() + 7) / 8) {
    for (Eight& eight : boxes_) {
        std::fill_n(&eight.low[0][0], 24, std::numeric_limits<float>::infinity());
        std::fill_n(&eight.high[0][0], 24, -std::numeric_limits<float>::infinity());
    }
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[triangles_[i]];
        const Vec3f low = mesh.vertices[a].cwiseMin(mesh.vertices[b]).cwiseMin(mesh.vertices[c]);
        const Vec3f high = mesh.vertices[a].cwiseMax(mesh.vertices[b]).cwiseMax(mesh.vertices[c]);
        for (int axis = 0; axis < 3; ++axis) {
            boxes_[i / 8].low[axis][i % 8] = low[axis];
            boxes_[i / 8].high[axis][i % 8] = high[axis];
        }
    }
}

}  // namespace tactooth
