// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "collision/bvh/surface.h"
#include "collision/neighbours/tool_shape.h"
#include "support/materials.h"
#include "support/shapes.h"
#include "tooth/model/material_registry.h"

namespace tactooth::test {

/// A block of one material, 10 mm wide, with its top at `top` mm.
[[nodiscard]] inline std::shared_ptr<const Surface> block(MaterialId material = test::kEnamel, double top = 0) {
    const std::vector<SurfaceTag> tags(12, static_cast<SurfaceTag>(material));
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(box(Vec3(-5, -5, -5), Vec3(5, 5, top)), tags);
    return surface;
}

inline constexpr double kBallRadius = 0.5;  // mm

/// A ball whose lowest vertex is the tip.
[[nodiscard]] inline std::shared_ptr<const ToolShape> ball() {
    return std::make_shared<const ToolShape>(sphere(Vec3(0, 0, kBallRadius), kBallRadius, 24, 12));
}

[[nodiscard]] inline Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }

}  // namespace tactooth::test
