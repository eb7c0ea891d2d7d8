// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/bench_stability_command.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "experiments/stability.h"
#include "session/io/run_metadata.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

bool isWanted(const std::vector<std::string>& names, std::string_view name) {
    return names.empty() || std::ranges::find(names, name) != names.end();
}

std::vector<StabilityCase> casesOf(const BenchStabilityOptions& options) {
    std::vector<StabilityCase> cases;
    for (const DevicePreset& device : devicePresets()) {
        for (const HandImpedance& hand : handImpedances()) {
            for (const auto& material : stabilityMaterials()) {
                for (int i = 0; i < kScenarioCount; ++i) {
                    const StabilityCase one{&device, &hand, material, static_cast<StabilityScenario>(i),
                                            options.rateHz};
                    if (isWanted(options.devices, device.name) && isWanted(options.hands, hand.name) &&
                        isWanted(options.materials, materialNameOf(one)) &&
                        isWanted(options.situations, stabilityScenarioName(one.situation))) {
                        cases.push_back(one);
                    }
                }
            }
        }
    }
    return cases;
}

Json jsonOf(const StabilityCase& one, const StabilityResult& result) {
    return {{"device", one.device->name},
            {"hand", one.hand->name},
            {"material", materialNameOf(one)},
            {"situation", stabilityScenarioName(one.situation)},
            {"stiffness_n_per_mm", result.stiffness},
            {"rest_force_n", result.restForce},
            {"ripple_percent", 100 * result.ripple},
            {"most_ripple_percent", 100 * result.maxRipple},
            {"least_energy_n_mm", result.minEnergy},
            {"strongest_n", result.maxForce},
            {"steepest_n_per_ms", result.maxForceRate},
            {"stable", result.stable}};
}

void printHead(double rateHz) {
    const RunMetadata facts = currentRunMetadata();
    print("machine:  {}\ncommit:   {}\ncommand:  {}\n", facts.machine, facts.commit, facts.command);
    print(
        "A simulated hand on a simulated device taps, presses, slides, trembles, cuts and lets go; the force that is "
        "computed at {:.0f} Hz moves it.\nk: stiffest spring, N/mm; rest: force while the hand rests, N; ripple of it, "
        "%; energy: least "
        "of the observer, N*mm;\npeak: strongest force, N; step: most in a millisecond, N.\n\n",
        rateHz);
    print("{:<10} {:<8} {:<9} {:<10} {:>5} {:>6} {:>7} {:>8} {:>6} {:>6}\n", "device", "hand", "material", "situation",
          "k", "rest", "ripple", "energy", "peak", "step");
}

void printRow(const StabilityCase& one, const StabilityResult& result) {
    print("{:<10} {:<8} {:<9} {:<10} {:>5.2f} {:>6.2f} {:>7.2f} {:>8.4f} {:>6.2f} {:>6.3f}{}\n", one.device->name,
          one.hand->name, materialNameOf(one), stabilityScenarioName(one.situation), result.stiffness, result.restForce,
          100 * result.ripple, result.minEnergy, result.maxForce, result.maxForceRate,
          result.stable ? "" : "  NOT STABLE");
}

/// The worse result of two runs.
StabilityResult worseOf(const StabilityResult& a, const StabilityResult& b) {
    return {std::max(a.stiffness, b.stiffness),
            std::max(a.restForce, b.restForce),
            std::max(a.ripple, b.ripple),
            std::max(a.maxRipple, b.maxRipple),
            std::min(a.minEnergy, b.minEnergy),
            std::max(a.maxForce, b.maxForce),
            std::max(a.maxForceRate, b.maxForceRate),
            a.stable && b.stable};
}

/// One line for each device and hand, over all materials and situations.
class Summary {
public:
    void add(const StabilityCase& one, const StabilityResult& result) {
        if (count_ > 0 && (one.device != device_ || one.hand != hand_)) end();
        device_ = one.device;
        hand_ = one.hand;
        worst_ = count_ == 0 ? result : worseOf(worst_, result);
        ++count_;
        stable_ += result.stable;
    }
    void end() {
        if (count_ == 0) return;
        print("{:<10} {:<8} {:<20} {:>5.2f} {:>6.2f} {:>7.2f} {:>8.4f} {:>6.2f} {:>6.3f}{}\n", device_->name,
              hand_->name, fmt::format("{} of {} stable", stable_, count_), worst_.stiffness, worst_.restForce,
              100 * worst_.ripple, worst_.minEnergy, worst_.maxForce, worst_.maxForceRate,
              stable_ == count_ ? "" : "  NOT STABLE");
        std::fflush(stdout);
        count_ = stable_ = 0;
    }

private:
    const DevicePreset* device_ = nullptr;
    const HandImpedance* hand_ = nullptr;
    StabilityResult worst_;
    int count_ = 0;
    int stable_ = 0;
};

}  // namespace

int runBenchStability(const BenchStabilityOptions& options) {
    Json json = Json::array();
    Summary summary;
    bool stable = true;
    if (!options.json) printHead(options.rateHz);
    for (const StabilityCase& one : casesOf(options)) {
        const StabilityResult result = runStability(one);
        stable &= result.stable;
        if (options.json) {
            json.push_back(jsonOf(one, result));
        } else if (options.all || !result.stable) {
            printRow(one, result);
        }
        if (!options.json && !options.all) summary.add(one, result);
    }
    summary.end();
    if (options.json) {
        const RunMetadata facts = currentRunMetadata();
        print("{}\n", Json{{"machine", facts.machine},
                           {"commit", facts.commit},
                           {"command", facts.command},
                           {"date", facts.date},
                           {"rate_hz", options.rateHz},
                           {"stable", stable},
                           {"cases", json}}
                          .dump(1, ' ', false, Json::error_handler_t::replace));
    }
    return stable ? kExitOk : kExitNegative;
}

}  // namespace tactooth
