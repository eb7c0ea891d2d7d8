// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Guarantees for the haptic loop: no allocation, and the same bits on every machine and in every build.
#include <gtest/gtest.h>

#include <bit>

#include "collision/contact_oracle.h"
#include "collision/proxy/proxy_solver.h"
#include "geometry/util/fnv1a.h"
#include "support/heap_counter.h"
#include "support/sanitizer.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

/// Numbers from arithmetic that every machine rounds in the same way: the square root is the only library function.
class Dice {
public:
    /// In -1..1.
    double next() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 40) / static_cast<double>(1 << 23) - 1;
    }
    Vec3 vector() {
        const double x = next();
        const double y = next();
        return {x, y, next()};
    }

private:
    std::uint64_t state_ = 42;
};

/// A bumpy plate, 0.1 mm between its vertices.
TriangleMesh bumps() {
    constexpr std::uint32_t kSide = 81;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
        const double x = 0.1 * (i % kSide) - 4;
        const double y = 0.1 * (i / kSide) - 4;
        const double height = 0.05 * x * x * (x * x - 6) + 0.04 * y * y * y - 0.3 * y;
        mesh.vertices.push_back(Vec3(x, y, 0.2 * height).cast<float>());
    }
    mesh.triangles = test::gridTriangles(kSide);
    return mesh;
}

/// An octahedron, subdivided twice and projected on a ball of 0.6 mm: 128 triangles.
TriangleMesh ball() {
    TriangleMesh mesh;
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < 2; ++level) {
        TriangleMesh finer;
        for (const Triangle& t : mesh.triangles) {
            const Vec3f a = mesh.vertices[t[0]];
            const Vec3f b = mesh.vertices[t[1]];
            const Vec3f c = mesh.vertices[t[2]];
            const auto first = static_cast<std::uint32_t>(finer.vertices.size());
            for (const Vec3f& v : {a, b, c, Vec3f(a + b), Vec3f(b + c), Vec3f(c + a)}) {
                finer.vertices.push_back(v / std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z()));
            }
            for (const Triangle& corner : {Triangle{0, 3, 5}, Triangle{3, 1, 4}, Triangle{5, 4, 2}, Triangle{3, 4, 5}})
                finer.triangles.push_back({first + corner[0], first + corner[1], first + corner[2]});
        }
        mesh = finer;
    }
    for (Vec3f& v : mesh.vertices) v = 0.6F * v + Vec3f(0, 0, 0.6F);
    return mesh;
}

/// A path of the device that wanders over the plate and presses into it.
Pose nextGoal(const Pose& device, Dice& dice) {
    Pose next = device;
    next.position += 0.04 * dice.vector() - 0.01 * (device.position - Vec3(0, 0, -0.1));
    const Vec3 turn = 0.01 * dice.vector();
    const Quat& q = device.rotation;
    const Vec3 v = q.vec() + q.w() * turn + turn.cross(q.vec());
    const double w = q.w() - turn.dot(q.vec());
    const double length = std::sqrt(w * w + v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
    next.rotation = Quat(w / length, v.x() / length, v.y() / length, v.z() / length);
    return next;
}

/// Follows the path and returns a hash of every pose (FNV-1a by 64-bit words).
std::uint64_t walk(int ticks, long& allocated, int& held) {
    ProxySolver solver(test::toolOf(ball()));
    solver.setSurface(test::surfaceOf(bumps(), false));
    Dice dice;
    Pose device{Vec3(0, 0, 1), Quat::Identity()};
    solver.placeAt(device);
    Fnv1a hash;
    const auto add = [&](double value) { hash.addWord(std::bit_cast<std::uint64_t>(value)); };
    const long before = test::heapCalls();
    for (int tick = 0; tick < ticks; ++tick) {
        device = nextGoal(device, dice);
        const MoveResult result = solver.moveToward(device);
        held += result.contactCount > 0 ? 1 : 0;
        for (int axis = 0; axis < 3; ++axis) add(solver.pose().position[axis]);
        for (int i = 0; i < 4; ++i) add(solver.pose().rotation.coeffs()[i]);
    }
    allocated = test::heapCalls() - before;
    return hash.value();
}

}  // namespace

TEST(RealTime, AHundredThousandTicksAllocateNothing) {
    constexpr int kTicks = test::cases(100000, 5000);
    long allocated = 0;
    int held = 0;
    walk(kTicks, allocated, held);
    EXPECT_EQ(allocated, 0);
    EXPECT_GT(held, kTicks / 10 * 3);
    EXPECT_LT(held, kTicks / 100 * 99);
}

TEST(RealTime, EqualRunsGiveEqualBits) {
    long allocated = 0;
    int held = 0;
    const std::uint64_t first = walk(3000, allocated, held);
    EXPECT_EQ(walk(3000, allocated, held), first);
}

/// The same in every build: with or without vector instructions, Debug or Release. A change of the algorithm may change
/// the number; a change of the build may not.
TEST(RealTime, EveryBuildGivesTheGoldenBits) {
    long allocated = 0;
    int held = 0;
    EXPECT_EQ(walk(20000, allocated, held), 2233738746588719192U);
}

}  // namespace tactooth
