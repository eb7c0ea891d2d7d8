// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/pulp_opening.h"

#include <gtest/gtest.h>

#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

/// A base, and a patch for each place: a little box of this material there.
Surface surfaceWith(std::initializer_list<std::pair<Vec3, MaterialId>> places) {
    Surface surface;
    surface.base = std::make_shared<const SurfacePart>(test::box(Vec3(-9, -9, -9), Vec3(9, 9, 9)));
    for (const auto& [place, material] : places) {
        TriangleMesh mesh = test::box(place - Vec3::Constant(0.05), place + Vec3::Constant(0.05));
        std::vector<SurfaceTag> tags(mesh.triangles.size(), static_cast<SurfaceTag>(material));
        surface.patches.push_back(std::make_shared<const SurfacePart>(std::move(mesh), std::move(tags)));
    }
    return surface;
}

TEST(PulpOpening, IsTheOpenPulpNearestToTheTip) {
    const Surface surface = surfaceWith({{Vec3(0, 0, 0.2), test::kDentin},
                                         {Vec3(0, 0, 3), test::kPulp},
                                         {Vec3(0, 0, -1), test::kPulp},
                                         {Vec3(0, 8, 0), test::kPulp}});
    const auto found = nearestPulp(surface, builtinMaterials(), Vec3::Zero());
    ASSERT_TRUE(found);
    EXPECT_LT((*found - Vec3(0, 0, -1)).norm(), 0.1);
    EXPECT_FALSE(nearestPulp(surface, builtinMaterials(), Vec3(0, -9, 0))) << "too far away";
    EXPECT_FALSE(nearestPulp(surfaceWith({{Vec3(0, 0, 1), test::kDentin}}), builtinMaterials(), Vec3::Zero()));
}

TEST(PulpOpening, LastsAsLongAsItsEvent) {
    CutEvents events(builtinMaterials(), {{CutEventKind::DentinReached, 1, Vec3(1, 1, 1)}});
    PulpOpening opening;
    const Surface closed = surfaceWith({});
    opening.follow(events, closed, builtinMaterials());
    EXPECT_FALSE(opening.place());
    events = CutEvents(builtinMaterials(), {{CutEventKind::PulpExposed, 2, Vec3(0, 0, 1)}});
    opening.follow(events, closed, builtinMaterials());
    EXPECT_EQ(opening.place(), Vec3(0, 0, 1)) << "until the surface shows it";
    opening.follow(events, surfaceWith({{Vec3(0, 0, 0), test::kPulp}}), builtinMaterials());
    EXPECT_LT(opening.place()->norm(), 0.1);
    const auto kept = opening.place();
    opening.follow(events, surfaceWith({{Vec3(0, 0, 0.9), test::kPulp}}), builtinMaterials());
    EXPECT_EQ(opening.place(), kept);
    (void)events.takeBack(0, 9);
    opening.follow(events, closed, builtinMaterials());
    EXPECT_FALSE(opening.place());
}

}  // namespace
}  // namespace tactooth
