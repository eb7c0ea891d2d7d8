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

/// State of a six-axis cap as spacenavd reports it: displacement right, up and away, and the rotations about these
/// axes.
struct SpaceMouseState {
    bool connected = false;
    std::array<int, 6> axes{};
    std::uint32_t buttons = 0;
};

/// The velocity that the user commands with the cap. The cap's axes reach about 350 counts each.
[[nodiscard]] RateCommand rateCommand(const SpaceMouseState& state);

/// A SpaceMouse, through the free driver spacenavd: its six axes give rate control of the tool. The device reconnects
/// when the driver is restarted. Only one of these at a time in a process, because libspnav has a single connection.
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
    std::jthread listener_;  // last member: it uses all of the above
};

}  // namespace tactooth
