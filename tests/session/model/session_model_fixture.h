// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/model_scene.h"

namespace tactooth::test {

/// A session with the block and the flat bur; the first step has been made.
class SessionModelTest : public testing::Test {
protected:
    void SetUp() override {
        model_.install(blockTooth());
        model_.install(flatSessionBur());
        (void)model_.step(0);
    }
    [[nodiscard]] bool soon(const std::function<bool()>& condition) { return stepUntil(model_, condition); }
    [[nodiscard]] bool ticksCome() {
        return soon([&] { return !model_.log().ticks().empty(); });
    }
    [[nodiscard]] Vec3 handle() const { return model_.log().newest().input.device.rotation * Vec3::UnitX(); }
    [[nodiscard]] Vec3 handPlace() const { return model_.log().newest().input.device.position; }
    StillDevice& installStill(DeviceSlot slot, const Vec3& workspace = Vec3::Zero()) {
        auto device = std::make_unique<StillDevice>(workspace, std::nullopt, Vec3::Zero());
        StillDevice& hand = *device;
        model_.install(slot, std::move(device));
        return hand;
    }
    /// The bur goes down into the block, its pedal pressed.
    void installHandThatPresses() {
        const auto at = [](double time, double z) {
            return DeviceKeyframe{time, {.hand = {Vec3(0, 0, z), Quat::Identity()}, .pedal = 1}};
        };
        std::vector<DeviceKeyframe> script{at(0, 1), at(0.2, 1), at(0.4, -0.4)};
        model_.install(DeviceSlot::First, std::make_unique<ScriptedDevice>(std::move(script), "press", true));
    }

    SpySound sound_;
    SessionModel model_{sound_, runInline};
};

}  // namespace tactooth::test
