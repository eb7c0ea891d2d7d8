// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/field/sampled_grid.h"

namespace tactooth {

/// The polygons of an isosurface before relaxation.
struct DualMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 4>> quads;
    std::vector<Triangle> triangles;  ///< of the few polygons with more than four corners
};

/// Makes a closed, oriented manifold from sampled values: one vertex for each patch of surface in a cell, and one quad
/// for each crossed grid edge. Use: `DualMesher(grid).mesh()`.
class DualMesher {
public:
    explicit DualMesher(const SampledGrid& grid);
    [[nodiscard]] DualMesh mesh() && { return std::move(mesh_); }

private:
    template <class Function>
    void forEachActiveCell(const Function& function) const;
    [[nodiscard]] std::size_t cellNumber(const Index3& c) const {
        return (static_cast<std::size_t>(c.z()) * cells_.y() + c.y()) * cells_.x() + c.x();
    }
    [[nodiscard]] int patchAt(const Index3& cell, int edge) const;
    [[nodiscard]] Vec3 crossing(const Index3& cell, int edge) const;
    void addVertices(const Index3& cell);
    void addPolygons(const Index3& cell);
    void addPolygon(const Index3& cell, int axis, bool outwardAlongAxis);
    void store(const std::vector<std::uint32_t>& polygon, int pivot);
    std::optional<std::uint32_t> vertexOnFace(const Index3& a, const Index3& b, int edgeOfA);

    const SampledGrid& grid_;
    Index3 cells_;
    std::vector<std::uint32_t> firstVertex_;  // of each cell
    std::vector<std::uint8_t> inside_;        // of each cell: bits of the inside corners
    std::map<std::pair<std::size_t, int>, std::uint32_t> faceVertices_;
    DualMesh mesh_;
};

}  // namespace tactooth
