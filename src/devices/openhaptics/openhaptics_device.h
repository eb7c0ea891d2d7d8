// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "devices/base/haptic_device.h"

namespace tactooth {

class HdDriver;
struct HdPen;

/// A pen of the PHANToM and Touch family, used through the vendor's own library (HDAPI), which is loaded at run time.
///
/// The driver's callback only exchanges a reading for a force; the servo thread computes in between, at the driver's
/// rate. If the servo thread is two ticks late, the callback renders a zero force; if the driver is late, the device
/// counts as lost. The program tries every second to restart a lost pen, which then works again without user action.
class OpenHapticsDevice final : public HapticDevice {
public:
    /// `device`: its name in the vendor's setup program; empty: the default one. `library`: see HdLibrary::load.
    OpenHapticsDevice(std::string device, std::string library, double rateHz = 1000);
    ~OpenHapticsDevice() override;

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override;
    void close() override;
    [[nodiscard]] bool drivesServoRate() const override { return true; }
    void waitForTick(double longest) override;
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override;
    [[nodiscard]] const Message* faultMessage() const override;

private:
    std::string name_;
    std::string library_;
    double rateHz_;
    DeviceInfo info_;
    std::shared_ptr<HdDriver> driver_;
    HdPen* pen_ = nullptr;     // owned by the driver
    bool hasReading_ = false;  // a reading has arrived since the device was opened
    double silence_ = 0;       // s since the last reading, or since the device was opened
    std::atomic<bool> silent_{false};
};

}  // namespace tactooth
