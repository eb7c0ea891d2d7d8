// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "collision/narrow/triangle3.h"
#include "collision/proxy/move_result.h"

namespace tactooth {

/// Normals of planes that may separate two triangles which touch: those of the faces and of each pair of edges, in both
/// senses; planes tilted over an edge; and directions that the caller adds. Fixed memory.
class ContactDirections {
public:
    /// The normals of both faces and of the nine pairs of edges. Edges that are parallel give none.
    ContactDirections(const Triangle3& tooth, const Triangle3& tool);

    /// Adds any unit direction; at most kMaxHeld of them.
    void add(const Vec3& direction);
    /// Adds planes through each edge of either triangle, tilted so far that they keep a distance of `least` (mm) from a
    /// corner of the other triangle. Only for corners nearer to the line of the edge than sqrt(reach); `reach` in mm^2.
    void addTilted(const Triangle3& tooth, const Triangle3& tool, double least, double reach);

    [[nodiscard]] int count() const { return count_; }
    /// Unit.
    [[nodiscard]] const Vec3& operator[](int i) const;

private:
    static constexpr int kOfPair = 2 * (2 + 9);
    static constexpr int kTilted = 2 * (9 + 9);
    static constexpr int kCapacity = kOfPair + kMaxHeld + kTilted;

    void addBothSenses(const Vec3& direction);
    void tiltOver(const Vec3& edge, const Vec3& fromToothToTool, double least, double reach);

    std::array<Vec3, kCapacity> unit_;
    int count_ = 0;
};

}  // namespace tactooth
