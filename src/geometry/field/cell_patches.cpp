// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/field/cell_patches.h"

#include <numeric>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr int kConfigurations = 256;

bool isCrossed(unsigned inside, int edge) {
    return ((inside >> edgeCorner(edge, 0)) & 1u) != ((inside >> edgeCorner(edge, 1)) & 1u);
}

/// Joins crossed edges that the surface connects across a face.
class Chains {
public:
    explicit Chains(unsigned inside) : inside_(inside) {
        std::iota(parent_.begin(), parent_.end(), 0);
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {0, 1}) connectFace(axis, side);
        }
    }
    [[nodiscard]] int root(int edge) const {
        while (parent_[edge] != edge) edge = parent_[edge];
        return edge;
    }

private:
    void join(int a, int b) { parent_[root(a)] = root(b); }

    void connectFace(int axis, int side) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (isAmbiguousFace(inside_, axis, side)) {
            for (int i = 0; i < 4; ++i) {
                const int corner = (side << axis) | ((i & 1) << u) | ((i >> 1) << v);
                if ((inside_ >> corner) & 1u) join(cornerEdge(corner, u), cornerEdge(corner, v));
            }
            return;
        }
        const int low = side << axis, high = low | (1 << u) | (1 << v);
        int first = -1;
        for (const int edge : {cornerEdge(low, u), cornerEdge(low, v), cornerEdge(high, u), cornerEdge(high, v)}) {
            if (!isCrossed(inside_, edge)) continue;
            if (first >= 0) join(first, edge);
            first = edge;
        }
    }

    unsigned inside_;
    std::array<int, kCellEdges> parent_{};
};

CellPatches findPatches(unsigned inside) {
    const Chains chains(inside);
    CellPatches result;
    std::array<int, kCellEdges> patchOfRoot;
    patchOfRoot.fill(-1);
    result.patchOfEdge.fill(-1);
    for (int edge = 0; edge < kCellEdges; ++edge) {
        if (!isCrossed(inside, edge)) continue;
        int& patch = patchOfRoot[chains.root(edge)];
        if (patch < 0) patch = result.count++;
        result.patchOfEdge[edge] = static_cast<std::int8_t>(patch);
    }
    TACTOOTH_ASSERT(result.count <= 4);
    return result;
}

}  // namespace

const CellPatches& cellPatches(unsigned inside) {
    static const std::array<CellPatches, kConfigurations> table = [] {
        std::array<CellPatches, kConfigurations> all;
        for (unsigned i = 0; i < kConfigurations; ++i) all[i] = findPatches(i);
        return all;
    }();
    TACTOOTH_ASSERT(inside < table.size());
    return table[inside];
}

}  // namespace tactooth
