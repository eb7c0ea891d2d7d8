// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/near_weld.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

using Cell = std::array<std::int64_t, 3>;

Cell cellOf(const Vec3& point, double size) {
    Cell cell;
    constexpr double kMost = 1e18;  // beyond it no float is near another one, and all share a cell
    for (int axis = 0; axis < 3; ++axis) {
        cell[axis] = static_cast<std::int64_t>(std::clamp(std::floor(point[axis] / size), -kMost, kMost));
    }
    return cell;
}

/// The vertices that stay, in the cells of a grid. Cells are some tolerances wide, so that most vertices have to search
/// a single cell.
class Kept {
public:
    explicit Kept(double tolerance) : tolerance_(tolerance), cell_(kCellWidth * tolerance) {}

    /// The vertex nearest to `point` within the tolerance. If there is none, `number` itself, which is then kept.
    std::uint32_t place(const Vec3f& point, std::uint32_t number, const std::vector<Vec3f>& vertices) {
        const Vec3 here = point.cast<double>();
        const Cell low = cellOf(here.array() - tolerance_, cell_), high = cellOf(here.array() + tolerance_, cell_);
        double nearest = tolerance_;
        std::uint32_t found = number;
        Cell cell;
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0]) {
            for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1]) {
                for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) {
                    const auto there = cells_.find(cell);
                    if (there == cells_.end()) continue;
                    for (const std::uint32_t other : there->second) {
                        const double distance = (vertices[other].cast<double>() - here).norm();
                        if (distance <= nearest) nearest = distance, found = other;
                    }
                }
            }
        }
        if (found == number) cells_[cellOf(here, cell_)].push_back(number);
        return found;
    }

private:
    static constexpr double kCellWidth = 8;  // width of a cell in tolerances

    double tolerance_;
    double cell_;
    struct Hash {
        std::size_t operator()(const Cell& cell) const {
            std::uint64_t mixed = 0;
            for (const std::int64_t place : cell) {
                mixed = (mixed ^ static_cast<std::uint64_t>(place)) * 0x9e3779b97f4a7c15U;
                mixed ^= mixed >> 32;
            }
            return static_cast<std::size_t>(mixed);
        }
    };
    // Never iterated, so its order has no influence.
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells_;
};

}  // namespace

TriangleMesh weldedWithin(const TriangleMesh& mesh, double tolerance, std::size_t* moved,
                          std::span<const std::uint8_t> mayMove) {
    TACTOOTH_ASSERT(std::isfinite(tolerance) && tolerance > 0);
    TACTOOTH_ASSERT(mayMove.empty() || mayMove.size() == mesh.vertices.size());
    Kept kept(tolerance);
    std::vector<std::uint32_t> place(mesh.vertices.size());
    std::vector<std::uint32_t> newNumber(mesh.vertices.size());
    TriangleMesh result;
    for (std::uint32_t v = 0; v < place.size(); ++v) {
        place[v] = mayMove.empty() || mayMove[v] != 0 ? kept.place(mesh.vertices[v], v, mesh.vertices) : v;
        TACTOOTH_ASSERT(place[v] <= v);
        if (place[v] != v) continue;
        newNumber[v] = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[v]);
    }
    if (moved != nullptr) *moved = mesh.vertices.size() - result.vertices.size();
    result.triangles.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        result.triangles.push_back({newNumber[place[a]], newNumber[place[b]], newNumber[place[c]]});
    }
    return result;
}

}  // namespace tactooth
