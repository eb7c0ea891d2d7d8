// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/haptic_device.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "devices/mouse/mouse_device.h"
#include "devices/simulated/null_device.h"
#include "devices/simulated/scripted_device.h"

namespace tactooth {
namespace {

template <class Device, class Force>
concept Accepts = requires(Device& device, Force force) {
    device.write(force);
};

template <class Device>
constexpr bool kTakesOnlySafeWrenches =
    Accepts<Device, SafeWrench> && !Accepts<Device, Wrench> && !Accepts<Device, Vec3> && !Accepts<Device, double>;

static_assert(kTakesOnlySafeWrenches<HapticDevice>);
static_assert(kTakesOnlySafeWrenches<MouseDevice>);
static_assert(kTakesOnlySafeWrenches<NullDevice>);
static_assert(kTakesOnlySafeWrenches<ScriptedDevice>);
static_assert(!std::is_copy_constructible_v<HapticDevice> && !std::is_copy_assignable_v<HapticDevice>);
static_assert(std::has_virtual_destructor_v<HapticDevice>);

TEST(HapticDevice, EveryDeviceOpensDescribesItselfAndIsConnected) {
    MouseDevice mouse{Pose{}};
    NullDevice none{Pose{}};
    ScriptedDevice script(std::vector<DeviceKeyframe>{{0, {}}});
    for (HapticDevice* device :
         {static_cast<HapticDevice*>(&mouse), static_cast<HapticDevice*>(&none), static_cast<HapticDevice*>(&script)}) {
        EXPECT_TRUE(device->open());
        EXPECT_FALSE(device->info().name.empty());
        EXPECT_TRUE(device->read(0.001).connected);
        device->write(SafeWrench());
        device->close();
    }
}

}  // namespace
}  // namespace tactooth
