// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "support/shapes.h"

#include <cmath>
#include <numbers>

namespace tactooth::test {

TriangleMesh box(const Vec3& low, const Vec3& high) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.vertices.push_back(Vec3((corner & 1) ? high.x() : low.x(), (corner & 2) ? high.y() : low.y(),
                                     (corner & 4) ? high.z() : low.z())
                                    .cast<float>());
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

TriangleMesh sphere(const Vec3& centre, double radius, int sectors, int rings) {
    TriangleMesh mesh;
    const auto add = [&](const Vec3& direction) {
        mesh.vertices.push_back((centre + radius * direction).cast<float>());
    };
    add(Vec3::UnitZ());
    for (int ring = 1; ring < rings; ++ring) {
        const double polar = std::numbers::pi * ring / rings;
        for (int sector = 0; sector < sectors; ++sector) {
            const double azimuth = 2 * std::numbers::pi * sector / sectors;
            add(Vec3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)));
        }
    }
    add(-Vec3::UnitZ());
    const auto at = [&](int ring, int sector) {
        return static_cast<std::uint32_t>(1 + (ring - 1) * sectors + sector % sectors);
    };
    const auto south = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    for (int sector = 0; sector < sectors; ++sector) {
        mesh.triangles.push_back({0, at(1, sector), at(1, sector + 1)});
        for (int ring = 1; ring + 1 < rings; ++ring) {
            mesh.triangles.push_back({at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1)});
            mesh.triangles.push_back({at(ring, sector), at(ring + 1, sector + 1), at(ring, sector + 1)});
        }
        mesh.triangles.push_back({south, at(rings - 1, sector + 1), at(rings - 1, sector)});
    }
    return mesh;
}

TriangleMesh cylinder(const Vec3& base, double radius, double height, int sectors) {
    TriangleMesh mesh;
    mesh.vertices.push_back(base.cast<float>());
    mesh.vertices.push_back((base + height * Vec3::UnitZ()).cast<float>());
    for (int sector = 0; sector < sectors; ++sector) {
        const double azimuth = 2 * std::numbers::pi * sector / sectors;
        const Vec3 rim = base + radius * Vec3(std::cos(azimuth), std::sin(azimuth), 0);
        mesh.vertices.push_back(rim.cast<float>());
        mesh.vertices.push_back((rim + height * Vec3::UnitZ()).cast<float>());
    }
    for (int sector = 0; sector < sectors; ++sector) {
        const auto low = static_cast<std::uint32_t>(2 + 2 * sector);
        const auto nextLow = static_cast<std::uint32_t>(2 + 2 * ((sector + 1) % sectors));
        mesh.triangles.push_back({0, nextLow, low});
        mesh.triangles.push_back({1, low + 1, nextLow + 1});
        mesh.triangles.push_back({low, nextLow, nextLow + 1});
        mesh.triangles.push_back({low, nextLow + 1, low + 1});
    }
    return mesh;
}

std::vector<Triangle> gridTriangles(std::uint32_t side) {
    std::vector<Triangle> triangles;
    for (std::uint32_t row = 0; row + 1 < side; ++row) {
        for (std::uint32_t i = row * side; i + 1 < row * side + side; ++i) {
            triangles.push_back({i, i + 1, i + side + 1});
            triangles.push_back({i, i + side + 1, i + side});
        }
    }
    return triangles;
}

}  // namespace tactooth::test
