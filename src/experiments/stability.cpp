// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "devices/simulated/simulated_device.h"
#include "experiments/stability_specimens.h"
#include "experiments/standard_teeth.h"
#include "haptics/cutting_force.h"
#include "haptics/force_pipeline.h"
#include "haptics/haptic_simulation.h"

namespace tactooth {
namespace {

constexpr std::array<std::string_view, kScenarioCount> kScenarios = {"tap",  "press",  "limit", "cusp",  "fissure",
                                                                     "slot", "let-go", "cut",   "tremor"};
constexpr double kHeadroom = 0.5;   // mm over the surface at the start
constexpr double kSettled = 1.2;    // s at which all motion has been asked for
constexpr double kEnd = 2.7;        // s
constexpr double kRest = 0.5;       // s at the end that are looked at
constexpr double kPressure = 1.0;   // N: what a dentist presses with
constexpr double kOverLimit = 1.2;  // of the device's peak
constexpr double kQuick = 0.012;    // s for the downward part of a tap: 100 mm/s and more ...
constexpr double kFastest = 500;    // mm/s: ... but no faster than a hand, on a spring so soft that the path is long
constexpr double kFaint = 0.05;     // N: below, a ripple means nothing

/// At the rate of the case, N/mm.
double stiffestOf(const StabilityCase& one) { return maxStiffnessAt(one.device->stiffness, one.rateHz); }

/// The spring that the hand will meet, N/mm.
double springOf(const StabilityCase& one) {
    if (!one.material) return stiffestOf(one);
    const MaterialTable materials;
    const double hardest = materials[builtinMaterials().withRole(MaterialRole::Enamel)].stiffness;
    return materials[*one.material].stiffness * std::min(1.0, stiffestOf(one) / hardest);
}

DeviceKeyframe at(double time, double x, double z) { return {time, {{Vec3(x, 0, z), Quat::Identity()}, 0, 0, true}}; }

/// Where the hand has to want to be so that its spring and the tooth's, one behind the other, hold `force`.
double pressedDepth(const StabilityCase& one, double force) {
    return force / one.hand->stiffness + force / springOf(one) + one.device->friction / one.hand->stiffness;
}

std::vector<DeviceKeyframe> scriptFor(const StabilityCase& one) {
    const double depth = pressedDepth(one, kPressure);
    switch (one.situation) {
        case StabilityScenario::Tap: {
            const double quick = std::max(kQuick, (kHeadroom + depth) / kFastest);
            return {at(0, 0, kHeadroom),           at(0.5, 0, kHeadroom),
                    at(0.5 + quick, 0, -depth),    at(0.7, 0, -depth),
                    at(0.7 + quick, 0, kHeadroom), at(kSettled - quick, 0, kHeadroom),
                    at(kSettled, 0, -depth),       at(kEnd, 0, -depth)};
        }
        case StabilityScenario::PressToLimit: {
            const double most = pressedDepth(one, kOverLimit * one.device->peakForce);
            return {at(0, 0, kHeadroom), at(0.5, 0, kHeadroom), at(kSettled, 0, -most), at(kEnd, 0, -most)};
        }
        case StabilityScenario::Cut:  // on a slope, where the bur pulls aside
        case StabilityScenario::Cusp:
            return {at(0, -1.5, kHeadroom),
                    at(0.5, -1.5, kHeadroom),
                    at(0.7, -1.5, -1.5 - 0.5 * depth),
                    at(1.0, 0, -0.5 * depth),
                    at(kSettled, 0.8, -0.8 - 0.5 * depth),
                    at(kEnd, 0.8, -0.8 - 0.5 * depth)};
        case StabilityScenario::Fissure:
            return {at(0, 0.4, kHeadroom), at(0.5, 0.4, kHeadroom), at(kSettled, 0, -kGrooveRest - depth),
                    at(kEnd, 0, -kGrooveRest - depth)};
        case StabilityScenario::Slot:
            return {at(0, 0, kHeadroom), at(0.5, 0, kHeadroom), at(0.9, 0, -kSlotDepth - depth),
                    at(kSettled, 0.5 * depth, -kSlotDepth - depth), at(kEnd, 0.5 * depth, -kSlotDepth - depth)};
        case StabilityScenario::Press:
        case StabilityScenario::Release:
        case StabilityScenario::Tremor:
            break;
    }
    return {at(0, 0, kHeadroom), at(0.5, 0, kHeadroom), at(kSettled, 0, -depth), at(kEnd, 0, -depth)};
}

std::shared_ptr<const Surface> specimenFor(const StabilityCase& one) {
    const MaterialId material = one.material.value_or(builtinMaterials().withRole(MaterialRole::Enamel));
    switch (one.situation) {
        case StabilityScenario::Cusp:
        case StabilityScenario::Cut:
            return ridgeSpecimen(material);
        case StabilityScenario::Fissure:
            return grooveSpecimen(material);
        case StabilityScenario::Slot:
            return slotSpecimen(material);
        default:
            return flatSpecimen(material);
    }
}

/// Mean and spread of the force at rest.
class RestMeter {
public:
    void add(double force) {
        sum_ += force;
        squares_ += force * force;
        ++count_;
    }
    [[nodiscard]] double mean() const { return count_ > 0 ? sum_ / count_ : 0; }
    [[nodiscard]] double ripple() const {
        if (mean() < kFaint) return 0;
        return std::sqrt(std::max(0.0, squares_ / count_ - mean() * mean())) / mean();
    }

private:
    double sum_ = 0;
    double squares_ = 0;
    double count_ = 0;
};

bool isStable(const StabilityCase& one, const StabilityResult& result, const ForceLimits& limits) {
    constexpr double kRounding = 1e-9;
    const bool rests = one.situation == StabilityScenario::Release || result.restForce > kFaint;
    return rests && result.ripple < result.maxRipple && result.minEnergy >= 0 &&
           result.maxForce <= limits.force + kRounding && result.maxForceRate <= 1e-3 * limits.slew + kRounding;
}

/// A cut shakes by a part of its force, and a tremor moves the hand to and fro on the spring.
double maxRippleOf(const StabilityCase& one, const StabilityResult& result) {
    if (one.situation == StabilityScenario::Cut) return kMaxRipple + kVibrationRatio;
    if (one.situation != StabilityScenario::Tremor || result.restForce < kFaint) return kMaxRipple;
    return kMaxRipple + result.stiffness * kTremor / result.restForce;
}

}  // namespace

std::string_view stabilityScenarioName(StabilityScenario situation) {
    return kScenarios[static_cast<std::size_t>(situation)];
}

std::vector<std::optional<MaterialId>> stabilityMaterials() {
    std::vector<std::optional<MaterialId>> materials;
    for (const MaterialRole role :
         {MaterialRole::Enamel, MaterialRole::Dentin, MaterialRole::Decay, MaterialRole::Pulp})
        materials.emplace_back(builtinMaterials().withRole(role));
    materials.emplace_back(std::nullopt);
    return materials;
}

std::string_view materialNameOf(const StabilityCase& one) {
    return one.material ? std::string_view(builtinMaterials().nameOf(*one.material)) : std::string_view("stiffest");
}

StabilityResult runStability(const StabilityCase& one) {
    SimulatedDevice::OperatorBehaviour habits;
    if (one.situation == StabilityScenario::Release) habits.releaseTime = kSettled + 0.3;
    if (one.situation == StabilityScenario::Tremor) habits.tremor = kTremor;
    const bool cuts = one.situation == StabilityScenario::Cut;
    SimulatedDevice hand(*one.device, *one.hand, scriptFor(one), habits);
    HapticSettings settings;
    if (!one.material) settings.force.stiffness = stiffestOf(one);
    static const auto tool = std::make_shared<const ToolShape>(standardBur());
    HapticSimulation simulation(tool, kStandardBurRadius, specimenFor(one), settings);
    simulation.force().setMaxStiffness(stiffestOf(one));
    ForcePipeline pipeline(hand.info().limits);

    StabilityResult result;
    RestMeter rest;
    Vec3 last = Vec3::Zero();
    const double dt = 1 / one.rateHz;
    const int ticks = static_cast<int>(kEnd * one.rateHz);
    for (int i = 0; i < ticks; ++i) {
        const DeviceSample sample = hand.read(dt);
        const Tick tick = simulation.step({sample.hand, cuts ? 1.0 : 0.0, cuts}, dt);
        ForceCommand wanted = forceCommandFrom(tick);
        wanted.hand = sample.hand.position;
        const SafeWrench sent = pipeline.pass(wanted, dt);
        hand.write(sent);
        const double force = sent.force().norm();
        if ((i + 1) * dt > kEnd - kRest) rest.add(force);
        result.stiffness = std::max(result.stiffness, tick.force.stiffness);
        result.minEnergy = std::min(result.minEnergy, pipeline.passivity().energy());
        result.maxForce = std::max(result.maxForce, force);
        result.maxForceRate = std::max(result.maxForceRate, (sent.force() - last).norm() / dt * 1e-3);
        last = sent.force();
    }
    result.restForce = rest.mean();
    result.ripple = rest.ripple();
    result.maxRipple = maxRippleOf(one, result);
    result.stable = isStable(one, result, hand.info().limits);
    return result;
}

}  // namespace tactooth
