// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/node_set.h"

#include "geometry/util/assert.h"

// Morphological dilation (J. Serra, "Image Analysis and Mathematical Morphology", 1982) and connected components of a
// brick's nodes. Difference: all nodes of a brick move at once, by shifts of its 512 bits.

namespace tactooth {
namespace {

/// Step from a node on one face of a brick to the opposite one.
constexpr int perpendicularTo(int axis) { return (kBrickSide - 1) * nodeStride(axis); }

NodeSet nodesOf(const BrickFace& face) {
    NodeSet nodes;
    for (int node = 0; node < kBrickNodes; ++node) {
        if (placeOf(node)[face.axis] == (face.isUpper ? kBrickSide - 1 : 0)) nodes.set(static_cast<std::size_t>(node));
    }
    return nodes;
}

/// The nodes one step up or down within the brick.
NodeSet up(const NodeSet& nodes, int axis) { return (nodes & ~BrickFace{axis, true}.nodes()) << nodeStride(axis); }
NodeSet down(const NodeSet& nodes, int axis) { return (nodes & ~BrickFace{axis, false}.nodes()) >> nodeStride(axis); }

NodeSets dilatedAlong(const NodeSets& sets, int axis) {
    NodeSets result;
    for (const auto& [key, nodes] : sets) {
        NodeSet wide = nodes | up(nodes, axis) | down(nodes, axis);
        for (const bool isUpper : {false, true}) {
            const BrickFace face{axis, isUpper};
            const auto beyond = sets.find(face.beyond(key));
            if (beyond == sets.end()) continue;
            const BrickFace back = face.opposite();
            wide |= back.across(beyond->second & back.nodes());
        }
        result.emplace_hint(result.end(), key, wide);
    }
    return result;
}

}  // namespace

const NodeSet& BrickFace::nodes() const {
    static const std::array<NodeSet, 6> kFaces = [] {
        std::array<NodeSet, 6> faces;
        for (int i = 0; i < 6; ++i) faces[i] = nodesOf(kBrickFaces[i]);
        return faces;
    }();
    TACTOOTH_ASSERT(axis >= 0 && axis < 3);
    return kFaces[2 * axis + (isUpper ? 1 : 0)];
}

NodeSet BrickFace::across(const NodeSet& own) const {
    TACTOOTH_ASSERT((own & ~nodes()).none());
    return isUpper ? own >> perpendicularTo(axis) : own << perpendicularTo(axis);
}

NodeSet solidNodes(const Brick& brick) {
    NodeSet solid;
    for (int node = 0; node < kBrickNodes; ++node) {
        solid[static_cast<std::size_t>(node)] = brick.tooth[node] < 0 && !(brick.cut[node] < 0);
    }
    return solid;
}

NodeSet firstComponent(const NodeSet& all) {
    NodeSet reached;
    for (std::size_t node = 0; node < all.size() && reached.none(); ++node) reached[node] = all[node];
    while (true) {
        NodeSet more = reached;
        for (int axis = 0; axis < 3; ++axis) more |= (up(more, axis) | down(more, axis)) & all;
        TACTOOTH_ASSERT((more & ~all).none());
        if (more == reached) return reached;
        reached = more;
    }
}

NodeSets dilated(const NodeSets& sets) { return dilatedAlong(dilatedAlong(dilatedAlong(sets, 0), 1), 2); }

}  // namespace tactooth
