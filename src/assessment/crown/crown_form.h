// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "assessment/crown/axial_walls.h"
#include "assessment/crown/finish_line.h"
#include "assessment/crown/occlusal_map.h"
#include "assessment/crown/removed_body.h"
#include "assessment/exercise.h"

namespace tactooth {

/// What a crown preparation removes, on the surface of one tooth: all above the finish line that lies outside the axial
/// walls, or nearer to the uncut surface than its reduction.
class CrownForm : public RemovedBody {
public:
    /// `plan` has a crown; `outer`: LayeredTooth::ownOuter. Fails with one sentence.
    [[nodiscard]] static Expected<CrownForm> make(const PreparationPlan& plan, const LayeredTooth& tooth,
                                                  std::shared_ptr<const SurfacePart> outer);

    [[nodiscard]] Depth depthAt(const Vec3& place) const override;
    [[nodiscard]] Box3 box() const override { return box_; }

    [[nodiscard]] const FinishLine& finishLine() const { return line_; }

private:
    /// The uncut surface of one side of the tooth, well above the finish line.
    struct Side {
        std::shared_ptr<const SurfacePart> faces;
        double depth;  // mm below them that is removed
    };
    CrownForm(const PreparationPlan& plan, FinishLine line, std::shared_ptr<const SurfacePart> outer);
    [[nodiscard]] double girthAbove(double side) const;
    void findAxialFaces(const CrownOutline& crown);
    [[nodiscard]] TriangleMesh aboveLine(const TriangleMesh& faces, double least) const;
    void findEdge(const CrownOutline& crown);
    [[nodiscard]] Depth belowEdge(const Vec3& place) const;

    FinishLine line_;
    AxialWalls walls_;
    std::shared_ptr<const SurfacePart> outer_;
    std::vector<Side> sides_;
    double rounding_;                      // mm: radius of the edges of the stump
    std::optional<OcclusalMap> occlusal_;  // of a tooth with cusps
    /// Height at which the stump of an anterior tooth ends, along the axis, at equal steps of the mesiodistal
    /// direction.
    std::vector<double> ends_;
    double endsFrom_ = 0;  // mm
    Box3 box_;
};

}  // namespace tactooth
