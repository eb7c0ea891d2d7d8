// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/sweep_lanes.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kSpacing = 0.025;  // mm
constexpr double kSide = 3;
constexpr double kClearance = 0.002;  // mm
constexpr double kNoBound = std::numeric_limits<double>::infinity();
constexpr double kSearchError = 1.1e-5;  // mm; both searches stop this near
constexpr double kFloatError = 1e-6;     // mm

/// Random places on the way of a bur, each with a step of a sweep and a cube beside its surface.
class Cases {
public:
    explicit Cases(const TriangleMesh& bur) : envelope_(*RevolutionEnvelope::make(bur)) {}

    double unit() { return unit_(random_); }

    SweepStep step(double way, double turn) {
        const Pose from{Vec3(7, -3, 11), Quat(Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()))};
        const Vec3 move = way * Vec3(unit(), unit(), unit());
        const Quat turned(Eigen::AngleAxisd(turn * unit(), Vec3(unit(), 1, unit()).normalized()));
        first_ = from * Vec3(0.7 * unit(), 0.7 * unit(), 1 + 1.2 * unit());
        return SweepStep(envelope_, from, {from.position + move, turned * from.rotation}, kClearance);
    }
    [[nodiscard]] const Vec3& first() const { return first_; }

    /// Eight places in the cube, in steps from its first node.
    Vec3x8 places(float (&place)[3][8]) {
        for (auto& axis : place) {
            for (float& value : axis) value = static_cast<float>(0.5 * kSide * (1 + unit()));
        }
        return Vec3x8::load(place);
    }
    [[nodiscard]] Vec3 pointAt(const float (&place)[3][8], int lane) const {
        return first_ + kSpacing * Vec3(place[0][lane], place[1][lane], place[2][lane]);
    }

private:
    RevolutionEnvelope envelope_;
    std::mt19937 random_{8};
    std::uniform_real_distribution<double> unit_{-1, 1};
    Vec3 first_;
};

struct Lanes {
    float distance[8];
    float gradient[3][8];
    explicit Lanes(const Samples8& samples) {
        samples.distance.store(distance);
        samples.gradient.store(gradient);
    }
};

std::vector<TriangleMesh> burs() {
    return {test::cylinder(Vec3::Zero(), 0.5, 2, 48), test::sphere(Vec3(0, 0, 0.5), 0.5, 64, 24)};
}

TEST(SweepLanes, SampleIsThatOfTheStepInEveryLane) {
    int turned = 0;
    int inside = 0;
    for (const TriangleMesh& mesh : burs()) {
        Cases cases(mesh);
        for (int i = 0; i < 2000; ++i) {
            const SweepStep step = cases.step(0.02, 0.01);
            const SweepLanes lanes(step, cases.first(), kSpacing, kSide, 0);
            float place[3][8];
            const Vec3x8 places = cases.places(place);
            const Lanes found(lanes.sample(places, Float8::all(std::numeric_limits<float>::infinity())));
            for (int lane = 0; lane < 8; ++lane) {
                const Vec3 point = cases.pointAt(place, lane);
                const FieldSample exact = step.sample(point, kNoBound);
                ASSERT_NEAR(found.distance[lane], exact.distance, kSearchError) << i << ' ' << lane;
                const Vec3 gradient(found.gradient[0][lane], found.gradient[1][lane], found.gradient[2][lane]);
                ASSERT_NEAR(gradient.norm(), 1, 1e-5);
                turned += (gradient - exact.gradient).norm() > 1e-2;  // beside an edge of the profile, or on its axis
                inside += exact.distance < 0;
            }
        }
    }
    EXPECT_LT(turned, 200) << "of 32,000";
    EXPECT_GT(inside, 3000);
}

TEST(SweepLanes, AStepThatStandsStillIsExactToAFloat) {
    Cases cases(burs()[1]);
    for (int i = 0; i < 2000; ++i) {
        const SweepStep step = cases.step(0, 0);
        const SweepLanes lanes(step, cases.first(), kSpacing, kSide, 0);
        float place[3][8];
        const Vec3x8 places = cases.places(place);
        const Lanes found(lanes.sample(places, Float8::all(std::numeric_limits<float>::infinity())));
        for (int lane = 0; lane < 8; ++lane) {
            ASSERT_NEAR(found.distance[lane], step.sample(cases.pointAt(place, lane), kNoBound).distance, kFloatError);
        }
    }
}

TEST(SweepLanes, ALaneIsBelowItsLimitOnlyWhereTheStepIs) {
    int below = 0;
    for (const TriangleMesh& mesh : burs()) {
        Cases cases(mesh);
        for (int i = 0; i < 2000; ++i) {
            const SweepStep step = cases.step(0.02, 0.01);
            const SweepLanes lanes(step, cases.first(), kSpacing, kSide, 0);
            float place[3][8];
            const Vec3x8 places = cases.places(place);
            float limit[8];
            for (float& value : limit) value = static_cast<float>(0.1 * cases.unit());
            const Lanes found(lanes.sample(places, Float8::load(limit)));
            for (int lane = 0; lane < 8; ++lane) {
                const double exact = step.sample(cases.pointAt(place, lane), kNoBound).distance;
                const double expected = std::min(exact, static_cast<double>(limit[lane]));
                ASSERT_NEAR(std::min(found.distance[lane], limit[lane]), expected, kSearchError) << i << ' ' << lane;
                below += exact < limit[lane];
            }
        }
    }
    EXPECT_GT(below, 3000);
}

/// Two balls on one axis: inside, the waist between them is nearest.
TriangleMesh waisted() {
    TriangleMesh mesh = test::sphere(Vec3(0, 0, 0.4), 0.4, 48, 16);
    const TriangleMesh upper = test::sphere(Vec3(0, 0, 1), 0.4, 48, 16);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), upper.vertices.begin(), upper.vertices.end());
    for (const auto& [a, b, c] : upper.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
    return mesh;
}

TEST(SweepLanes, APointAtTheVeryHeightOfACornerOfTheProfileKeepsItsSide) {
    const auto envelope = RevolutionEnvelope::make(waisted());
    ASSERT_TRUE(envelope);
    int inside = 0;
    for (const auto& corner : envelope->profile()) {
        for (int i = 0; i < 20; ++i) {
            const Vec3 point(0.025 * i, 0, corner.z);
            const SweepStep step(*envelope, Pose{}, Pose{}, 0);
            const SweepLanes lanes(step, point - Vec3::Constant(0.5 * kSide * kSpacing), kSpacing, kSide, 0);
            const Float8 middle = Float8::all(0.5 * kSide);
            const Lanes found(lanes.sample({middle, middle, middle}, Float8::all(1)));
            ASSERT_NEAR(found.distance[0], step.sample(point, kNoBound).distance, kFloatError) << point.transpose();
            inside += found.distance[0] < -0.01;
        }
    }
    EXPECT_GT(inside, 100);
}

TEST(SweepLanes, AProfileOfTooManyPiecesIsSampledAllTheSame) {
    Cases cases(test::sphere(Vec3(0, 0, 0.05), 0.05, 64, 512));
    int inside = 0;
    for (int i = 0; i < 200; ++i) {
        const SweepStep step = cases.step(0.01, 0);
        const Vec3 first = Vec3(7, -3, 11) - Vec3::Constant(0.05);
        const SweepLanes lanes(step, first, kSpacing, kSide, 0);
        float place[3][8];
        const Vec3x8 places = cases.places(place);
        const Lanes found(lanes.sample(places, Float8::all(std::numeric_limits<float>::infinity())));
        for (int lane = 0; lane < 8; ++lane) {
            const Vec3 point = first + kSpacing * Vec3(place[0][lane], place[1][lane], place[2][lane]);
            const double exact = step.sample(point, kNoBound).distance;
            ASSERT_NEAR(found.distance[lane], exact, kSearchError);
            inside += exact < 0;
        }
    }
    EXPECT_GT(inside, 100);
}

}  // namespace
}  // namespace tactooth
