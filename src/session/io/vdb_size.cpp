// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "geometry/util/number_text.h"
#include "session/io/messages.h"
#include "session/io/vdb_file.h"

namespace tactooth {
namespace {

constexpr double kMaxBytes = 4e9;  // in memory: a molar with its layers at 5 um

double areaOf(const TriangleMesh& mesh) {
    double twice = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 corner = mesh.vertices[a].cast<double>();
        const Vec3 one = mesh.vertices[b].cast<double>() - corner, other = mesh.vertices[c].cast<double>() - corner;
        twice += one.cross(other).norm();
    }
    return twice / 2;
}

}  // namespace

Expected<void> checkVdbSize(const LayeredTooth& tooth, double voxel) {
    double area = areaOf(tooth.outer()->mesh());
    for (const LayeredTooth::Layer& layer : tooth.layers()) area += areaOf(layer.part->mesh());
    // Where a surface passes, both materials need a brick of voxels; the inside needs a few blocks.
    const double side = kBrickSide * voxel;
    const double bytes = area / (side * side) * 2 * kBrickNodes * sizeof(float);
    if (bytes <= kMaxBytes) return {};
    return unexpected(msg::kVdbTooLarge, std::llround(bytes / 1e9), numberText(voxel));
}

}  // namespace tactooth
