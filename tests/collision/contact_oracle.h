// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision/neighbours/tool_shape.h"
#include "geometry/mesh/triangle_mesh.h"
#include "support/exact_intersection.h"

namespace tactooth::test {

struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
};

/// An incisor, a canine and a molar: real ones if the real data are available, else the built-in ones.
[[nodiscard]] const std::vector<NamedMesh>& oracleTeeth();

/// The built-in teeth, and every tooth of the real data if they are available.
[[nodiscard]] const std::vector<NamedMesh>& everyTooth();

/// A ball and a cylinder of the catalogue, and the STL of a tapered bur if the real data are available.
[[nodiscard]] const std::vector<NamedMesh>& oracleTools();

/// These, and a pear and a tapered diamond of the catalogue.
[[nodiscard]] const std::vector<NamedMesh>& everyKindOfTool();

[[nodiscard]] std::shared_ptr<const Surface> surfaceOf(TriangleMesh mesh, bool closed = true);
[[nodiscard]] std::shared_ptr<const ToolShape> toolOf(TriangleMesh mesh);

/// Decides whether a tool is free of a closed tooth, without any code of the collision layer: by CGAL's exact
/// predicates for the surfaces, and by the winding number for a tool that is wholly inside.
class Oracle {
public:
    Oracle(const TriangleMesh& tooth, const TriangleMesh& tool) : tooth_(tooth), tool_(tool), surfaces_(tooth, tool) {}

    [[nodiscard]] bool touches(const Pose& toolInTooth) const { return surfaces_.at(toolInTooth); }
    /// Whether the tool's first vertex is inside the tooth.
    [[nodiscard]] bool encloses(const Pose& toolInTooth) const;
    [[nodiscard]] bool isFree(const Pose& toolInTooth) const { return !touches(toolInTooth) && !encloses(toolInTooth); }

private:
    TriangleMesh tooth_;
    TriangleMesh tool_;
    ExactIntersection surfaces_;
};

}  // namespace tactooth::test
