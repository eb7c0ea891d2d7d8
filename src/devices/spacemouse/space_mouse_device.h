// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <thread>

#include "devices/base/haptic_device.h"
#include "devices/base/rate_controller.h"
#include "geometry/util/triple_buffer.h"

namespace tactooth {

/// A cap of six axes at one moment, as spacenavd tells it: right, up, away and the turns about them.
struct SpaceMouseState {
    bool connected = false;
    std::array<int, 6> axes{};
    std::uint32_t buttons = 0;
};

/// What the hand on the cap wants. The cap's axes count to about 350 each.
[[nodiscard]] RateCommand rateCommand(const SpaceMouseState& state);

/// A SpaceMouse through the free driver spacenavd: its six axes steer the tool by speed. A driver that is started again
/// is found again. One of these at a time in a process, as libspnav has one connection.
class SpaceMouseDevice final : public HapticDevice {
public:
    SpaceMouseDevice();
    ~SpaceMouseDevice() override;

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    /// Fails if the driver does not run.
    [[nodiscard]] Expected<void> open() override;
    void close() override;
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override { hand_.setForce(wrench.force()); }
    [[nodiscard]] const Message* faultMessage() const override;

private:
    void run(const std::stop_token& stop);

    DeviceInfo info_;
    TripleBuffer<SpaceMouseState> state_;  // listener -> servo
    RateController hand_;
    std::atomic<bool> lost_{false};
    bool open_ = false;
    std::jthread listener_;  // last: it uses all of the above
};

}  // namespace tactooth
