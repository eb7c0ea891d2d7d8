// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "tooth/volume/brick.h"

namespace tactooth {

/// What turns one cut field of a brick into another one. It holds only the nodes that differ, and of these only those
/// that some bur has reached: a stroke changes a few of the 512 nodes of most of its bricks.
class FieldChange {
public:
    /// `spacing` in mm.
    [[nodiscard]] static FieldChange between(const CutField& from, const CutField& to, double spacing);
    /// `field` is the `from` of `between`; afterwards it is its `to`, bit for bit.
    void apply(CutField& field, double spacing) const;
    [[nodiscard]] std::size_t bytes() const { return sizeof *this + values_.capacity() * sizeof(NodeField); }

private:
    /// The cut field at one node.
    struct NodeField {
        float cut = 0;
        OctahedralNormal cutNormal;
        std::array<HermiteSample, 3> boundary;
    };

    NodeBits changed_;
    NodeBits untouched_;  // of these, the nodes that no bur has reached in `to`
    bool isCut_ = false;
    std::vector<NodeField> values_;  // of the other changed nodes, in their order
};

}  // namespace tactooth
