// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/mesh/append_subset.h"
#include "geometry/mesh/crack_weld.h"
#include "geometry/mesh/mesh_repair.h"
#include "geometry/mesh/mesh_specks.h"
#include "geometry/mesh/near_weld.h"
#include "geometry/mesh/simplify.h"
#include "geometry/mesh/subdivide.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(TriangleMesh, IsInvalidWithACornerThatIsNoVertexOrNotFinite) {
    TriangleMesh mesh = test::box(Vec3::Zero(), Vec3::Ones());
    mesh.vertices.emplace_back(std::nanf(""), 0.0F, 0.0F);  // unused
    EXPECT_FALSE(test::firstInvalidTriangle(mesh));
    mesh.triangles[7][0] = 8;
    EXPECT_EQ(test::firstInvalidTriangle(mesh), 7U);
    mesh.triangles[5][2] = 9;
    EXPECT_EQ(test::firstInvalidTriangle(mesh), 5U);
}

/// A mesh that random steps change: it may have holes, duplicates, degenerate triangles and several components.
class RandomMesh {
public:
    explicit RandomMesh(unsigned seed) : random_(seed) {}

    void step() {
        switch (below(8)) {
            case 0:
                append(mesh_, test::sphere(Vec3(number(), number(), number()), 0.2 + std::abs(number()), 9, 6));
                break;
            case 1:
                append(mesh_, test::box(Vec3(-1, -1, -1), Vec3(std::abs(number()), 0.5, 0.5)));
                break;
            case 2: {
                TriangleMesh part;
                appendSubset(part, mesh_, [&](std::uint32_t) { return below(4) != 0; });
                mesh_ = std::move(part);
                break;
            }
            case 3:
                mesh_ = weldedWithin(mesh_, 0.001 + 0.1 * std::abs(number()));
                break;
            case 4:
                mesh_ = subdividedTo(mesh_, mesh_.triangles.size() + below(50));
                break;
            case 5:
                mesh_ = transformed(
                    mesh_, {Vec3(number(), number(), number()), Quat(Eigen::AngleAxisd(number(), Vec3::UnitY()))});
                break;
            case 6:
                (void)weldCracks(mesh_);
                (void)removeDuplicates(mesh_);
                (void)dropSpecks(mesh_);
                break;
            default:
                mesh_ = repaired(mesh_, {.holes = HolesToFill::All}).mesh;
        }
    }
    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

private:
    [[nodiscard]] std::size_t below(std::size_t limit) {
        return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_);
    }
    [[nodiscard]] double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

    std::mt19937 random_;
    TriangleMesh mesh_ = test::box(Vec3::Zero(), Vec3::Ones());
};

TEST(TriangleMesh, StaysValidAfterEachOfManyRandomOperations) {
    std::size_t triangles = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomMesh mesh(seed);
        for (int i = 0; i < 25; ++i) {
            mesh.step();
            ASSERT_FALSE(test::firstInvalidTriangle(mesh.mesh())) << "seed " << seed << ", step " << i;
            triangles += mesh.mesh().triangles.size();
        }
    }
    EXPECT_GT(triangles, 20'000U);  // the sample means something
}

TEST(TriangleMesh, StaysValidInComponentsAndAfterSimplification) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        RandomMesh mesh(seed);
        for (int i = 0; i < 12; ++i) mesh.step();
        for (const TriangleMesh& component : connectedComponents(mesh.mesh()))
            EXPECT_FALSE(test::firstInvalidTriangle(component));
        const TriangleMesh ball = test::sphere(Vec3::Zero(), 1, 10 + static_cast<int>(seed), 8);
        EXPECT_FALSE(test::firstInvalidTriangle(simplified(ball, 40 + seed)));
    }
}

}  // namespace
}  // namespace tactooth
