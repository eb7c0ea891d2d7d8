// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "collision/bvh/surface.h"

namespace tactooth {

/// A crown seen from above. Tooth frame, mm.
class CrownView {
public:
    /// `outer`: LayeredTooth::ownOuter.
    explicit CrownView(std::shared_ptr<const SurfacePart> outer);

    [[nodiscard]] const Box3& box() const { return box_; }
    /// Height of the crown at a place; lowest of all where there is none.
    [[nodiscard]] double heightAt(double x, double y) const;
    /// Middle of the contact area on a proximal side; `towardX`: 1 or -1.
    [[nodiscard]] Vec3 contact(double towardX) const;
    /// Distance of the outermost point of a proximal side from the tooth's axis.
    [[nodiscard]] double outside(double towardX) const { return towardX > 0 ? box_.max().x() : -box_.min().x(); }
    /// The same in one direction at one height.
    [[nodiscard]] double outsideAt(double towardX, double y, double z) const;

private:
    [[nodiscard]] const std::vector<Vec3f>& vertices() const { return surface_.base->mesh().vertices; }

    Surface surface_;
    Box3 box_;
};

}  // namespace tactooth
