// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Up to two and a half million triangles: a minute.
#include <gtest/gtest.h>

#include "geometry/mesh/simplify.h"
#include "geometry/mesh/subdivide.h"
#include "haptic_path.h"

namespace tactooth {

TEST(LongSmoothForce, TheSameToothFeelsTheSameFromTenThousandToTwoAndAHalfMillionTriangles) {
    TriangleMesh tooth = simplified(test::oracleTeeth()[2].mesh, 9500);
    const TriangleMesh ground = tooth;
    const test::ForceStats coarse[] = {test::forceAlong(ground, tooth, 10), test::forceAlong(ground, tooth, 66)};
    for (int level = 0; level < 4; ++level) {
        tooth = subdivided(tooth, 1);
        for (const int fast : {0, 1}) {
            const test::ForceStats fine = test::forceAlong(ground, tooth, fast != 0 ? 66 : 10);
            EXPECT_NEAR(fine.mean, coarse[fast].mean, 0.02 * coarse[fast].mean)
                << tooth.triangles.size() << " " << fast;
            EXPECT_NEAR(fine.peak, coarse[fast].peak, 0.02 * coarse[fast].peak)
                << tooth.triangles.size() << " " << fast;
        }
    }
    EXPECT_GT(tooth.triangles.size(), 2000000U);
}

}  // namespace tactooth
