// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth::test {

/// The oracle for common points of two surfaces: CGAL's exact predicates on the given doubles, with CGAL's own box
/// search; shares no code with the tested code.
class ExactIntersection {
public:
    ExactIntersection(const TriangleMesh& fixed, const TriangleMesh& moving);
    ~ExactIntersection();
    ExactIntersection(const ExactIntersection&) = delete;
    ExactIntersection& operator=(const ExactIntersection&) = delete;

    /// Whether a triangle of the moving surface at `pose` meets a triangle of the fixed one.
    [[nodiscard]] bool at(const Pose& pose) const;

private:
    struct Index;
    Index* index_;
};

}  // namespace tactooth::test
