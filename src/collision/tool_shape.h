// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/surface.h"

namespace tactooth {

/// The moving side of a contact query: a tool's STL with what is computed once for it. Read-only after construction.
class ToolShape {
public:
    explicit ToolShape(TriangleMesh mesh);

    [[nodiscard]] const SurfacePart& part() const { return part_; }
    [[nodiscard]] const TriangleMesh& mesh() const { return part_.mesh(); }
    /// Unit outward normal, or zero for a triangle without area.
    [[nodiscard]] const Vec3f& normal(std::uint32_t triangle) const { return normals_[triangle]; }
    /// Centre of the bounding box in the tool frame, mm.
    [[nodiscard]] const Vec3& centre() const { return centre_; }
    /// Every vertex lies within this distance of the centre, mm.
    [[nodiscard]] double radius() const { return radius_; }

private:
    SurfacePart part_;
    std::vector<Vec3f> normals_;
    Vec3 centre_ = Vec3::Zero();
    double radius_ = 0;
};

}  // namespace tactooth
