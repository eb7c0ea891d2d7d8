// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability.h"

#include <gtest/gtest.h>

#include "experiments/stability_specimens.h"
#include "geometry/mesh/mesh_report.h"
#include "support/materials.h"

namespace tactooth {
namespace {

StabilityCase caseOf(const char* device, const char* hand, std::optional<MaterialId> material,
                     StabilityScenario situation) {
    return {findDevicePreset(device), findHandImpedance(hand), material, situation, 1000};
}

TEST(Stability, EveryDeviceAndHandStaysSteadyOnEnamelAndAtTheStiffestWall) {
    for (const DevicePreset& device : devicePresets()) {
        for (const HandImpedance& hand : handImpedances()) {
            for (const auto& material : {std::optional(test::kEnamel), std::optional<MaterialId>()}) {
                for (const StabilityScenario situation :
                     {StabilityScenario::Tap, StabilityScenario::Fissure, StabilityScenario::Release,
                      StabilityScenario::Cut, StabilityScenario::Tremor}) {
                    const StabilityCase one{&device, &hand, material, situation, 1000};
                    const StabilityResult result = runStability(one);
                    EXPECT_TRUE(result.stable) << device.name << ' ' << hand.name << ' ' << materialNameOf(one) << ' '
                                               << stabilityScenarioName(situation) << ": ripple " << result.ripple
                                               << ", energy " << result.minEnergy;
                }
            }
        }
    }
}

TEST(Stability, ATouchXRendersOneNewtonAMillimetre) {
    const StabilityResult result = runStability(caseOf("touch-x", "loose", test::kEnamel, StabilityScenario::Press));
    EXPECT_TRUE(result.stable);
    EXPECT_NEAR(result.stiffness, 1.0, 1e-9);
    EXPECT_NEAR(result.restForce, 1.0, 0.1);
}

// A loose hand, because a firm one holds the bur against the pull.
TEST(Stability, ACutPullsAsideAndShakes) {
    const StabilityResult still = runStability(caseOf("touch-x", "loose", test::kEnamel, StabilityScenario::Cusp));
    const StabilityResult cut = runStability(caseOf("touch-x", "loose", test::kEnamel, StabilityScenario::Cut));
    EXPECT_GT(cut.restForce, 1.05 * still.restForce) << "half of the normal force pulls along the rim";
    EXPECT_GT(cut.ripple, 0.005);
    EXPECT_LT(still.ripple, 1e-6);
    EXPECT_GE(cut.minEnergy, 0) << "the energy of its pull comes from the drive";
}

// On an arm without friction, since friction would hide the effect.
TEST(Stability, ATremorShakesTheForce) {
    DevicePreset smooth = *findDevicePreset("omega");
    smooth.friction = 0;
    const auto run = [&](StabilityScenario situation) {
        return runStability({&smooth, findHandImpedance("nominal"), test::kEnamel, situation, 1000});
    };
    const StabilityResult press = run(StabilityScenario::Press), tremor = run(StabilityScenario::Tremor);
    EXPECT_LT(press.ripple, kMaxRipple);
    EXPECT_GT(tremor.ripple, 10 * press.ripple);
    EXPECT_NEAR(tremor.restForce, press.restForce, 0.1);
}

TEST(Stability, ASofterDeviceSoftensAllMaterialsTogether) {
    const auto stiffnessOf = [](MaterialId material) {
        return runStability(caseOf("omni", "firm", material, StabilityScenario::Press)).stiffness;
    };
    EXPECT_NEAR(stiffnessOf(test::kEnamel), 0.5, 1e-9);
    EXPECT_NEAR(stiffnessOf(test::kDentin), 0.325, 1e-9);
}

TEST(Stability, PressingToTheLimitGivesTheDevicesForceAndNoMore) {
    const StabilityResult result =
        runStability(caseOf("touch", "firm", test::kEnamel, StabilityScenario::PressToLimit));
    EXPECT_NEAR(result.restForce, 3.3, 1e-6);
    EXPECT_LE(result.maxForce, 3.3 + 1e-9);
}

TEST(Stability, AWallThatNoDeviceBearsIsCalledUnstable) {
    DevicePreset device = *findDevicePreset("omega");
    device.stiffness = 60;  // twenty times what it renders
    device.friction = device.damping = 0;
    const StabilityCase one{&device, findHandImpedance("loose"), std::nullopt, StabilityScenario::Press, 1000};
    EXPECT_FALSE(runStability(one).stable);
}

TEST(Stability, EqualRunsGiveEqualBits) {
    const StabilityCase one = caseOf("inverse3", "nominal", test::kCaries, StabilityScenario::Cusp);
    const StabilityResult first = runStability(one);
    const StabilityResult second = runStability(one);
    EXPECT_EQ(first.restForce, second.restForce);
    EXPECT_EQ(first.minEnergy, second.minEnergy);
    EXPECT_EQ(first.maxForceRate, second.maxForceRate);
}

TEST(StabilitySpecimens, EncloseTheVolumeOfTheirProfile) {
    // 80 mm wide and long, 60 mm high, less what the profile takes away.
    const auto volumeOf = [](const std::shared_ptr<const Surface>& piece) {
        return reportOn(piece->base->mesh()).signedVolume;
    };
    EXPECT_NEAR(volumeOf(flatSpecimen(test::kEnamel)), 80 * 80 * 60, 1e-3);
    EXPECT_NEAR(volumeOf(ridgeSpecimen(test::kEnamel)), 80 * (80 * 60 - 40 * 40), 1e-3);
    EXPECT_NEAR(volumeOf(grooveSpecimen(test::kEnamel)), 80 * (80 * 60 - 1), 1e-3);
    EXPECT_NEAR(volumeOf(slotSpecimen(test::kEnamel)), 80 * (80 * 60 - 2 * 0.77), 1e-3);
}

}  // namespace
}  // namespace tactooth
