// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/sweep/sweep_lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kSpacing = 0.025;  // mm
constexpr double kSide = 3;
constexpr double kClearance = 0.002;  // mm
constexpr double kNoBound = std::numeric_limits<double>::infinity();
constexpr double kSearchError = 1.1e-5;  // mm; both searches stop within this
constexpr double kFloatError = 1e-6;     // mm

/// Random places on the path of a bur, each with a step of a sweep and a cube at its surface.
class Cases {
public:
    explicit Cases(const TriangleMesh& bur) : envelope_(*RevolutionEnvelope::make(bur)) {}

    [[nodiscard]] const RevolutionEnvelope& envelope() const { return envelope_; }
    double unit() { return unit_(random_); }

    SweepStep step(double distance, double turn) {
        const Pose from{Vec3(7, -3, 11), Quat(Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()))};
        const Vec3 move = distance * Vec3(unit(), unit(), unit());
        const Quat turned(Eigen::AngleAxisd(turn * unit(), Vec3(unit(), 1, unit()).normalized()));
        first_ = from * Vec3(0.7 * unit(), 0.7 * unit(), 1 + 1.2 * unit());
        return SweepStep(envelope_, from, {from.position + move, turned * from.rotation}, kClearance);
    }
    [[nodiscard]] const Vec3& first() const { return first_; }

    /// Eight places in the cube, in steps from its first node.
    void fill(float (&place)[3][8]) {
        for (auto& axis : place) {
            for (float& value : axis) value = static_cast<float>(0.5 * kSide * (1 + unit()));
        }
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

/// Calls `check(cases, step, lanes, place)` for 2,000 steps of a bur, each with eight places near it. Stops at the
/// first failure.
template <class Check>
void forRandomSteps(const TriangleMesh& bur, double distance, double turn, const Check& check) {
    Cases cases(bur);
    for (int i = 0; i < 2000 && !::testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(i);
        const SweepStep step = cases.step(distance, turn);
        const SweepLanes lanes(step, cases.first(), kSpacing, kSide, 0);
        float place[3][8];
        cases.fill(place);
        check(cases, step, lanes, place);
    }
}

Lanes unlimited(const SweepLanes& lanes, const float (&place)[3][8]) {
    return Lanes(lanes.sample(Vec3x8::load(place), Float8::all(std::numeric_limits<float>::infinity())));
}

TEST(SweepLanes, SampleIsThatOfTheStepInEveryLane) {
    int turned = 0;
    int inside = 0;
    for (const TriangleMesh& mesh : burs()) {
        forRandomSteps(
            mesh, 0.02, 0.01, [&](const Cases& cases, const auto& step, const auto& lanes, const auto& place) {
                const Lanes found = unlimited(lanes, place);
                for (int lane = 0; lane < 8; ++lane) {
                    const FieldSample exact = step.sample(cases.pointAt(place, lane), kNoBound);
                    ASSERT_NEAR(found.distance[lane], exact.distance, kSearchError) << lane;
                    const Vec3 gradient(found.gradient[0][lane], found.gradient[1][lane], found.gradient[2][lane]);
                    ASSERT_NEAR(gradient.norm(), 1, 1e-5);
                    turned +=
                        (gradient - exact.gradient).norm() > 1e-2;  // beside an edge of the profile, or on its axis
                    inside += exact.distance < 0;
                }
            });
    }
    EXPECT_LT(turned, 200) << "of 32,000";
    EXPECT_GT(inside, 3000);
}

TEST(SweepLanes, AStepThatStandsStillIsExactToAFloat) {
    forRandomSteps(burs()[1], 0, 0, [](const Cases& cases, const auto& step, const auto& lanes, const auto& place) {
        const Lanes found = unlimited(lanes, place);
        for (int lane = 0; lane < 8; ++lane) {
            ASSERT_NEAR(found.distance[lane], step.sample(cases.pointAt(place, lane), kNoBound).distance, kFloatError);
        }
    });
}

TEST(SweepLanes, ALaneIsBelowItsLimitOnlyWhereTheStepIs) {
    int below = 0;
    for (const TriangleMesh& mesh : burs()) {
        forRandomSteps(mesh, 0.02, 0.01, [&](Cases& cases, const auto& step, const auto& lanes, const auto& place) {
            float limit[8];
            for (float& value : limit) value = static_cast<float>(0.1 * cases.unit());
            const Lanes found(lanes.sample(Vec3x8::load(place), Float8::load(limit)));
            for (int lane = 0; lane < 8; ++lane) {
                const double exact = step.sample(cases.pointAt(place, lane), kNoBound).distance;
                const double expected = std::min(exact, static_cast<double>(limit[lane]));
                ASSERT_NEAR(std::min(found.distance[lane], limit[lane]), expected, kSearchError) << lane;
                below += exact < limit[lane];
            }
        });
    }
    EXPECT_GT(below, 3000);
}

// A tangent plane of the envelope shows at once which of the eight places a step does not reach.
TEST(SweepLanes, WhereAStepMayNotReachItDoesNot) {
    int left = 0;
    int all = 0;
    for (const TriangleMesh& mesh : burs()) {
        forRandomSteps(mesh, 0.1, 0.01, [&](Cases& cases, const auto& step, const auto& lanes, const auto& place) {
            const float limit = static_cast<float>(0.05 * cases.unit());
            const Vec3x8 places = Vec3x8::load(place);
            ++all;
            if (lanes.mayReach(places, Float8::all(limit))) return;
            ++left;
            for (int lane = 0; lane < 8; ++lane) {
                ASSERT_GE(step.sample(cases.pointAt(place, lane), kNoBound).distance, limit) << lane;
            }
        });
    }
    EXPECT_GT(left, 0.3 * all);
    EXPECT_LT(left, 0.7 * all);
}

/// Balls on one axis, the first one at the tip. Where they overlap, the waist between them is nearest from inside.
TriangleMesh ballsInARow(int count, double radius, double spacing) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const TriangleMesh ball = test::sphere(Vec3(0, 0, radius + i * spacing), radius, 48, 16);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), ball.vertices.begin(), ball.vertices.end());
        for (const auto& [a, b, c] : ball.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
    }
    return mesh;
}

TEST(SweepLanes, APointAtTheVeryHeightOfACornerOfTheProfileKeepsItsSide) {
    const auto envelope = RevolutionEnvelope::make(ballsInARow(2, 0.4, 0.6));
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

/// A cone of rings on one line. Every second ring lies slightly inside. After bridging, its profile is straight, or
/// almost, at each ring.
TriangleMesh ringedCone() {
    constexpr int kAround = 32;
    constexpr int kRings = 9;
    constexpr double kHair = 0.0003;  // mm
    TriangleMesh mesh;
    for (int ring = 0; ring < kRings; ++ring) {
        const double z = 0.25 * ring;
        const double radius = 0.27 + 0.0523 * z - (ring % 2 == 0 ? 0 : kHair);
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2 * std::numbers::pi * i / kAround;
            mesh.vertices.emplace_back(Vec3(radius * std::cos(angle), radius * std::sin(angle), z).cast<float>());
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring) {
        for (std::uint32_t i = 0; i < kAround; ++i) {
            const std::uint32_t next = kAround * ring + (i + 1) % kAround;
            const std::uint32_t here = kAround * ring + i;
            mesh.triangles.push_back({here, next, here + kAround});
            mesh.triangles.push_back({next, next + kAround, here + kAround});
        }
    }
    return mesh;
}

TEST(SweepLanes, APointBesideACornerThatGoesStraightOnKeepsItsSide) {
    const auto envelope = RevolutionEnvelope::make(ringedCone());
    ASSERT_TRUE(envelope);
    ASSERT_LT(envelope->profile().size(), 8U) << "or its rings were not bridged";
    const Pose still{Vec3(3, -2, 5), Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
    const SweepStep step(*envelope, still, still, 0);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    int inside = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto& corner = envelope->profile()[2 + i % (envelope->profile().size() - 4)];
        const double off = 0.25 * unit(random);
        const Vec3 onAxis(0, 0, corner.z - 0.0523 * off + 3e-4 * unit(random));
        const Vec3 point = still * (onAxis + Vec3(corner.radius + off, 0, 0));
        const SweepLanes lanes(step, point - Vec3::Constant(0.5 * kSide * kSpacing), kSpacing, kSide, 0);
        const Float8 middle = Float8::all(0.5 * kSide);
        const Lanes found(lanes.sample({middle, middle, middle}, Float8::all(1)));
        ASSERT_NEAR(found.distance[0], step.sample(point, kNoBound).distance, kFloatError) << i;
        inside += found.distance[0] < 0;
    }
    EXPECT_GT(inside, 5000);
}

// Beside a waist the distance along a step has two minima, so that each part of the step is searched.
TEST(SweepLanes, AStepPastAWaistIsSearchedInParts) {
    const auto envelope = RevolutionEnvelope::make(ballsInARow(2, 0.4, 0.6));
    ASSERT_TRUE(envelope);
    constexpr int kParts = 4;
    constexpr double kWay = 0.1;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    int beside = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3 move = kWay * Vec3(unit(random), unit(random), unit(random)).normalized();
        const SweepStep step(*envelope, Pose{}, {move, Quat::Identity()}, 0, kParts);
        const Vec3 point = Vec3(0.27 + 0.05 * unit(random), 0.05 * unit(random), 0.7 + 0.1 * unit(random));
        const SweepLanes lanes(step, point - Vec3::Constant(0.5 * kSide * kSpacing), kSpacing, kSide, 0);
        const Float8 middle = Float8::all(0.5 * kSide);
        const Lanes found(lanes.sample({middle, middle, middle}, Float8::all(1)));
        double least = kNoBound;
        for (int moment = 0; moment <= 400; ++moment) {
            least = std::min(least, envelope->signedDistance(point - moment / 400.0 * move));
        }
        ASSERT_GE(found.distance[0], least - kWay / 400);
        ASSERT_LE(found.distance[0], least + 0.5 * kWay / kParts);
        ASSERT_NEAR(found.distance[0], step.sample(point, kNoBound).distance, kSearchError);
        beside += std::abs(found.distance[0]) < 0.05;
    }
    EXPECT_GT(beside, 200);
}

TEST(SweepLanes, AProfileOfTooManyPiecesIsSampledAllTheSame) {
    Cases cases(ballsInARow(30, 0.01, 0.015));
    const Vec3 middle(0, 0, 0.2);
    ProfilePart part;
    ASSERT_FALSE(cases.envelope().findPart(middle, cases.envelope().signedDistance(middle), kSide * kSpacing, part))
        << "or the other tests are enough";
    int inside = 0;
    for (int i = 0; i < 200; ++i) {
        const SweepStep step(cases.envelope(), Pose{}, {0.005 * Vec3(cases.unit(), cases.unit(), 0), Quat::Identity()},
                             0);
        const Vec3 first = middle - Vec3::Constant(0.5 * kSide * kSpacing);
        const SweepLanes lanes(step, first, kSpacing, kSide, 0);
        float place[3][8];
        cases.fill(place);
        const Lanes found = unlimited(lanes, place);
        for (int lane = 0; lane < 8; ++lane) {
            const Vec3 point = first + kSpacing * Vec3(place[0][lane], place[1][lane], place[2][lane]);
            const double exact = step.sample(point, kNoBound).distance;
            ASSERT_NEAR(found.distance[lane], exact, kFloatError);
            inside += exact < 0;
        }
    }
    EXPECT_GT(inside, 20);
}

}  // namespace
}  // namespace tactooth
