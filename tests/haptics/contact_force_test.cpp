// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/contact_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/materials.h"
#include "support/servo_tick.h"

namespace tactooth {
namespace {

const MaterialTable kMaterials;
const Material kEnamel = kMaterials[test::kEnamel];
const Material kDentin = kMaterials[test::kDentin];

ContactPoint heldBy(MaterialId material, double depth, const Vec3& point = Vec3::Zero()) {
    return {point, Vec3::UnitZ(), depth, material};
}

/// The device is `depth` below a horizontal plane and moves at `velocity`.
Wrench onPlane(ContactForce& law, double depth, const Vec3& velocity, double travel = 0,
               MaterialId material = test::kEnamel, const Vec3& place = Vec3::Zero()) {
    const ContactPoint held = heldBy(material, depth);
    return law.at({place - Vec3(0, 0, depth), Vec3(0, 0, depth), velocity, travel, {&held, 1}});
}

double pushOn(ContactForce& law, double travel, MaterialId material) {
    return onPlane(law, 0.1, Vec3::Zero(), travel, material).force.z();
}

TEST(ContactForce, IsASpringAndADamperAlongTheNormal) {
    for (const double depth : {1e-6, 0.01, 0.5, 2.0}) {
        for (const double sinking : {-1.0, 0.0, 3.0, 100.0}) {
            ContactForce law;
            const Vec3 force = onPlane(law, depth, Vec3(0, 0, -sinking)).force;
            const double expected = std::max(0.0, kEnamel.stiffness * depth + kEnamel.damping * sinking);
            EXPECT_NEAR(force.z(), expected, 1e-12);
            EXPECT_EQ(force.x(), 0);
            EXPECT_EQ(force.y(), 0);
            EXPECT_NEAR(law.normalForce(), expected, 1e-12);
        }
    }
}

TEST(ContactForce, NeverPulls) {
    ContactForce law;
    const Wrench wrench = onPlane(law, 0.1, Vec3(30, 0, 1000));
    EXPECT_EQ(wrench.force, Vec3::Zero());
    EXPECT_EQ(wrench.torque, Vec3::Zero());
    EXPECT_EQ(law.normalForce(), 0);
}

TEST(ContactForce, FrictionOpposesSlidingAndStaysBelowTheCone) {
    std::mt19937 random(20260201);
    std::uniform_real_distribution<double> speed(-200, 200);
    for (int i = 0; i < 1000; ++i) {
        ContactForce law;
        const Vec3 sliding(speed(random), speed(random), 0);
        onPlane(law, 0.3, sliding);
        const Vec3 force = onPlane(law, 0.3, sliding, 0, test::kEnamel, 0.001 * sliding).force;
        const Vec3 friction(force.x(), force.y(), 0);
        EXPECT_LE(friction.norm(), kEnamel.friction * law.normalForce() * (1 + 1e-12));
        EXPECT_NEAR(friction.normalized().dot(sliding.normalized()), -1, 1e-12);
    }
}

TEST(ContactForce, FrictionGrowsWithTheDisplacementUpToTheCone) {
    ContactForce law;
    EXPECT_EQ(onPlane(law, 0.3, Vec3::Zero()).force.x(), 0);
    const double full = kEnamel.friction * kEnamel.stiffness * 0.3;
    const double cone = kEnamel.friction * 0.3;  // mm, at the stiffness of the spring
    const auto at = [&](double x) { return onPlane(law, 0.3, Vec3::Zero(), 0, test::kEnamel, Vec3(x, 0, 0)); };
    EXPECT_NEAR(at(cone / 2).force.x(), -full / 2, 1e-12);
    EXPECT_NEAR(at(cone / 2).force.x(), -full / 2, 1e-12) << "a hand that stops is held";
    EXPECT_NEAR(at(5).force.x(), -full, 1e-12);
    EXPECT_NEAR(law.deflection(), std::hypot(0.3, cone), 1e-12);
    EXPECT_NEAR(at(5 - cone).force.x(), 0, 1e-12) << "on the way back first what was drawn is let go";
}

TEST(ContactForce, ATurningRimReleasesFriction) {
    ContactForce law;
    const ContactPoint held = heldBy(test::kEnamel, 0.3);
    ContactState contact{Vec3(0, 0, -0.3), Vec3(0, 0, 0.3), Vec3::Zero(), 0, {&held, 1}};
    (void)law.at(contact);
    contact.device.x() = 1;
    contact.rimTravel = 20;  // mm in a tick: 1.4 mm of bur at 300,000 rpm
    EXPECT_NEAR(law.at(contact).force.x(), 0, 1e-12);
}

TEST(ContactForce, WithoutContactThereIsNoForce) {
    ContactForce law;
    EXPECT_EQ(law.at({Vec3::Zero(), Vec3(0, 0, 0.1), Vec3(0, 0, -9), 0, {}}).force, Vec3::Zero());
    EXPECT_EQ(onPlane(law, 0, Vec3(0, 0, -9)).force, Vec3::Zero());
    EXPECT_EQ(law.normalForce(), 0);
}

TEST(ContactForce, AcrossABorderTheMaterialBlendsByTravelAndNotByTicks) {
    ContactForce fine;
    ContactForce coarse;
    pushOn(fine, 0, test::kEnamel);
    pushOn(coarse, 0, test::kEnamel);
    for (int i = 0; i < 49; ++i) pushOn(fine, 0.001, test::kDentin);
    const double inFifty = pushOn(fine, 0.001, test::kDentin);
    EXPECT_NEAR(inFifty, pushOn(coarse, 0.05, test::kDentin), 1e-12);
    const double left = (inFifty / 0.1 - kDentin.stiffness) / (kEnamel.stiffness - kDentin.stiffness);
    EXPECT_NEAR(left, std::exp(-3), 1e-12);
}

TEST(ContactForce, AToolAtRestKeepsItsMaterial) {
    ContactForce law;
    const double before = pushOn(law, 0, test::kEnamel);
    EXPECT_EQ(pushOn(law, 0, test::kCaries), before);
}

TEST(ContactForce, ANewContactStartsWithItsOwnMaterial) {
    ContactForce law;
    pushOn(law, 0, test::kEnamel);
    onPlane(law, 0, Vec3::Zero());
    EXPECT_DOUBLE_EQ(pushOn(law, 0, test::kDentin), kDentin.stiffness * 0.1);
}

TEST(ContactForce, TwoMaterialsAreWeightedByTheirShares) {
    ContactForce law;
    const std::array held = {heldBy(test::kEnamel, 0.3), heldBy(test::kDentin, 0.1)};
    const Wrench wrench = law.at({Vec3(0, 0, -0.4), Vec3(0, 0, 0.4), Vec3::Zero(), 0, held});
    EXPECT_NEAR(wrench.force.z(), 0.4 * (0.75 * kEnamel.stiffness + 0.25 * kDentin.stiffness), 1e-12);
}

TEST(ContactForce, AContactWithoutDepthHasAMaterial) {
    ContactForce law;
    const ContactPoint held = heldBy(test::kDentin, 0);
    const Wrench wrench = law.at({Vec3::Zero(), Vec3(0, 0, 1e-9), Vec3::Zero(), 0, {&held, 1}});
    EXPECT_NEAR(wrench.force.z(), 1e-9 * kDentin.stiffness, 1e-15);
    EXPECT_TRUE(wrench.torque.allFinite());
}

TEST(ContactForce, OverridesHoldAtOnceAndTheScaleMultipliesTheWholeForce) {
    ContactForce law;
    pushOn(law, 0, test::kEnamel);
    law.setOverrides({.stiffness = 3.0, .damping = 0.5, .friction = 0.0});
    law.setScale(2);
    const Vec3 force = onPlane(law, 0.1, Vec3(40, 0, -1)).force;
    EXPECT_NEAR(force.z(), 2 * (3.0 * 0.1 + 0.5 * 1), 1e-12);
    EXPECT_EQ(force.x(), 0);
    law.setOverrides({});
    law.setScale(1);
    EXPECT_DOUBLE_EQ(pushOn(law, 0, test::kEnamel), 0.1 * kEnamel.stiffness);
}

TEST(ContactForce, AnOffCentreContactTurnsTheTool) {
    ContactForce law;
    const Vec3 tip(3, 4, 5);
    const Vec3 arm(0.7, -0.2, 1.1);
    const ContactPoint held = heldBy(test::kEnamel, 0.2, tip + Vec3(0, 0, 0.2) + arm);
    const Wrench wrench = law.at({tip, Vec3(0, 0, 0.2), Vec3(8, 0, 0), 0, {&held, 1}});
    EXPECT_TRUE(wrench.torque.isApprox(arm.cross(wrench.force), 1e-12));
    EXPECT_GT(wrench.torque.norm(), 0.05);
}

TEST(ContactForce, ARotationIntoAContactIsDampedLikeATranslation) {
    const Vec3 tip(3, 4, 5);
    const ContactPoint held = heldBy(test::kEnamel, 0.2, tip + Vec3(2, 0, 0.2));
    const Vec3 offset(0, 0, 0.2);
    ContactForce moving, turning;
    const Wrench moved = moving.at({tip, offset, Vec3(0, 0, -6), 0, {&held, 1}});
    const Wrench turned = turning.at({tip, offset, Vec3::Zero(), 0, {&held, 1}, Vec3(0, 3, 0)});
    EXPECT_NEAR(turned.force.z(), moved.force.z(), 1e-12);
    EXPECT_NEAR(turned.force.z(), 0.2 * kEnamel.stiffness + 6 * kEnamel.damping, 1e-12);
}

TEST(ContactForce, EqualContactsOnBothSidesDoNotTurnTheTool) {
    ContactForce law;
    const Vec3 offset(0, 0, 0.2);
    const std::array held = {heldBy(test::kEnamel, 0.1, Vec3(0.6, 0, 0.2)),
                             heldBy(test::kEnamel, 0.1, Vec3(-0.6, 0, 0.2))};
    const Wrench wrench = law.at({Vec3::Zero(), offset, Vec3::Zero(), 0, held});
    EXPECT_LT(wrench.torque.norm(), 1e-15);
    EXPECT_DOUBLE_EQ(wrench.force.z(), 0.2 * kEnamel.stiffness);
}

TEST(ContactForce, ChangesByAtMost50MillinewtonAMillisecondAtABorder) {
    using test::kTick;
    for (const double depth : {0.1, 1.0, 3.0}) {
        for (const double travel : {0.001, 0.01, 0.1}) {
            ContactForce law;
            double last = 0;
            for (int i = 0; i < 300; ++i) {
                const ContactPoint held = heldBy(i < 100 ? test::kCaries : test::kEnamel, depth);
                const ContactState contact{Vec3(0, 0, -depth), Vec3(0, 0, depth), Vec3::Zero(), travel,
                                           {&held, 1},         Vec3::Zero(),      kTick};
                const double force = law.at(contact).force.z();
                if (i > 0) {
                    EXPECT_LE(std::abs(force - last), 0.05 + 1e-12);
                }
                last = force;
            }
            if (travel > 0.005) {
                EXPECT_NEAR(last, kEnamel.stiffness * depth, 0.01);
            }
        }
    }
}

TEST(ContactForce, ReturnsNaNAndResetsItsMemory) {
    const double bad = std::nan("");
    for (int what = 0; what < 4; ++what) {
        ContactForce law;
        (void)onPlane(law, 0.1, Vec3::Zero());
        const ContactPoint held = heldBy(test::kEnamel, what == 3 ? bad : 0.1);
        const Vec3 offset(0, 0, 0.1);
        const Vec3 wrong(0, 0, bad);
        const Wrench wrench = law.at({what == 0 ? wrong : Vec3(-offset),
                                      offset,
                                      what == 1 ? wrong : Vec3(0, 0, 0),
                                      what == 2 ? bad : 0.0,
                                      {&held, 1}});
        EXPECT_FALSE(wrench.force.allFinite() && wrench.torque.allFinite()) << what;
        EXPECT_EQ(law.normalForce(), 0) << what;
        ContactForce fresh;
        EXPECT_EQ(onPlane(law, 0.2, Vec3::Zero()).force, onPlane(fresh, 0.2, Vec3::Zero()).force) << what;
    }
}

}  // namespace
}  // namespace tactooth
