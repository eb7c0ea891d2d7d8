// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/doctor_devices.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "devices/device_enumeration.h"
#include "devices/process/fault_log.h"
#include "devices/process/hand_process.h"
#include "geometry/files/file_bytes.h"

namespace tactooth {
namespace {

constexpr const char* kArea = "hand process";
constexpr std::size_t kShownFaults = 3;

/// Rounded to tenths, independent of the locale.
std::string tenths(double value) {
    const long rounded = std::lround(10 * value);
    return std::to_string(rounded / 10) + '.' + std::to_string(rounded % 10);
}

/// "2026-11-27 07:08:22 UTC, Touch, 1.8 N: no fresh force for 3 ms"
std::string faultText(const FaultRecord& fault) {
    const std::string force = fault.force > 0 ? ", " + tenths(fault.force) + " N" : "";
    return faultTimeText(fault.time) + ", " + fault.device + force + ": " + std::string(textOf(fault.cause).english);
}

Finding checkHandProcess() {
    const std::filesystem::path program = handProgram();
    if (::access(program.c_str(), X_OK) != 0) {
        return {kArea, FindingState::Optional,
                "The program that holds the devices is missing (" + displayName(program) +
                    "): install Tactooth anew, or start it with --device-in-process."};
    }
    const std::filesystem::path log = faultLogFile();
    const std::vector<FaultRecord> faults = readFaults(log, kShownFaults);
    if (faults.empty())
        return {kArea, FindingState::Fine, "The program that holds the devices is there; it has no faults."};
    std::string text = "The force of a device was cut; the last faults (" + displayName(log) + "):";
    for (const FaultRecord& fault : faults) text += ' ' + faultText(fault) + (&fault == &faults.back() ? "." : ";");
    return {kArea, FindingState::Fine, text};
}

/// The name that --device takes is added where several devices of one kind are connected.
std::string titleOf(const DetectedDevice& device) {
    const bool isOneOfSeveral = device.name.find(':') != std::string::npos;
    return isOneOfSeveral ? device.name + ", " + device.backend : device.backend;
}

}  // namespace

std::vector<Finding> checkDevices() {
    std::vector<Finding> findings = {checkHandProcess()};
    for (const DetectedDevice& device : enumerateDevices()) {
        const bool isReady = device.state == DeviceState::Ready;
        findings.push_back(
            {"device", isReady ? FindingState::Fine : FindingState::Optional, titleOf(device) + ": " + device.text});
    }
    return findings;
}

}  // namespace tactooth
