// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "collision/contact_oracle.h"
#include "collision/proxy/proxy_solver.h"
#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }

TEST(ProxySolver, AssertsThatItHasASurfaceAndAFiniteGoal) {
    ProxySolver body(test::toolOf(test::box(Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 1))));
    EXPECT_ASSERT((void)body.moveToward(at(0, 0, 1)));
    body.setSurface(test::surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, 0)), false));
    EXPECT_ASSERT((void)body.moveToward(at(0, 0, std::nan(""))));
    EXPECT_ASSERT(body.placeAt(at(0, 0, 1 / 0.0)));
    EXPECT_ASSERT(body.setBudget(-1));
}

}  // namespace
}  // namespace tactooth
