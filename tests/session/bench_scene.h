// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <numbers>

#include "session/live/live_runner.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth::test {

inline constexpr double kVoxel = 0.05;     // mm
inline constexpr double kBurRadius = 0.4;  // mm

/// A block of one material, 3 mm wide and high, whose top lies at zero, on the bench.
[[nodiscard]] inline std::shared_ptr<CutModel> blockOnTheBench(MaterialId material = test::kDentin,
                                                               const MaterialRegistry& materials = builtinMaterials()) {
    auto tooth = LayeredTooth::make(box(Vec3(-1.5, -1.5, -3), Vec3(1.5, 1.5, 0)), {}, material, {}, materials);
    return std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), kVoxel);
}

[[nodiscard]] inline TriangleMesh flatBurMesh() { return cylinder(Vec3::Zero(), kBurRadius, 4, 32); }

[[nodiscard]] inline Instrument flatBur(double sharpness = 1) {
    return {std::make_shared<const ToolShape>(flatBurMesh()), {*RevolutionEnvelope::make(flatBurMesh()), sharpness}};
}

[[nodiscard]] inline Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }

/// Cuts a ridge 3 mm long, 1.1 mm wide and 0.4 mm thick off the block's top, all around.
inline void cutARidgeOff(CutModel& piece) {
    piece.sweep(flatBur().cutting, at(-2.5, 0, -1), at(2.5, 0, -1));
    const Quat lying(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitX()));  // the shaft along y
    piece.sweep(flatBur().cutting, {Vec3(-2.5, 0, -0.8), lying}, {Vec3(2.5, 0, -0.8), lying});
}

/// A block with a core of dentin, cut into both.
[[nodiscard]] inline std::shared_ptr<CutModel> cutBlock() {
    TriangleMesh outer = box(Vec3(-2, -2, -3), Vec3(2, 2, 0));
    std::vector<LayerMesh> layers;
    layers.push_back({"enamel", test::kEnamel, outer});
    layers.push_back({"core", test::kDentin, box(Vec3(-1, -1, -2), Vec3(1, 1, -0.3))});
    auto tooth = LayeredTooth::make(std::move(outer), std::move(layers));
    auto piece = std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), kVoxel);
    piece->sweep(flatBur().cutting, at(0, 0, 0.2), at(0.1, 0, -0.6));
    piece->sweep(flatBur().cutting, at(0.1, 0, -0.6), at(0.5, 0.3, -0.5));
    piece->refreshSurface();
    return piece;
}

}  // namespace tactooth::test
