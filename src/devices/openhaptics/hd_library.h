// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "geometry/util/expected.h"

namespace tactooth {

// The binary interface of HDAPI, the device library of OpenHaptics, as far as this program uses it: names, types and
// numbers as public bindings list them. The library itself is part of the user's own installation and is found at run
// time.

using HdHandle = std::uint32_t;
using HdEnum = std::uint32_t;
using HdCallback = std::uint32_t (*)(void* user);
inline constexpr std::uint32_t kHdContinue = 1;

struct HdErrorRecord {
    std::uint32_t code;
    std::int32_t internalCode;
    HdHandle device;
};

namespace hd {
inline constexpr HdEnum kButtons = 0x2000;    // 1 int, one bit for each button
inline constexpr HdEnum kTransform = 0x2052;  // 16 doubles, column by column, mm; +x right, +y up, +z toward the user
inline constexpr HdEnum kModel = 0x2501;      // text
inline constexpr HdEnum kUsableWorkspace = 0x2551;   // 6 doubles: smallest xyz, largest xyz, mm
inline constexpr HdEnum kCalibrationStyle = 0x2555;  // 1 int
inline constexpr HdEnum kMaxForce = 0x2603;          // 1 double, N
inline constexpr HdEnum kContinuousForce = 0x2604;   // 1 double, N
inline constexpr HdEnum kMotorTemperature = 0x2605;  // 3 doubles, 0 cold .. 1 hot
inline constexpr HdEnum kForce = 0x2700;             // 3 doubles, N; setting replaces the previous force
inline constexpr HdEnum kForceOutput = 0x4000;       // switch
inline constexpr HdEnum kForceClamping = 0x4001;     // switch
inline constexpr HdEnum kCalibrated = 0x5000;
inline constexpr HdEnum kNeedsUpdate = 0x5001;
inline constexpr std::uint16_t kDefaultPriority = 32767;
inline constexpr HdHandle kLargestHandle = 1024;  // a failed start may return a large number and no error

inline constexpr std::uint32_t kWarmMotors = 0x0200;
inline constexpr std::uint32_t kTooMuchForce = 0x0201;
inline constexpr std::uint32_t kTooMuchImpulse = 0x0202;
inline constexpr std::uint32_t kTooFast = 0x0203;
inline constexpr std::uint32_t kForceError = 0x0204;
inline constexpr std::uint32_t kDeviceFault = 0x0300;
inline constexpr std::uint32_t kAlreadyStarted = 0x0301;
inline constexpr std::uint32_t kLinkFault = 0x0302;
inline constexpr std::uint32_t kLinkSettings = 0x0303;
inline constexpr std::uint32_t kTimer = 0x0304;
inline constexpr std::uint32_t kSchedulerFull = 0x0501;
inline constexpr std::uint32_t kNoLicence = 0x0600;
}  // namespace hd

/// The functions of the library; none is null.
struct HdFunctions {
    HdHandle (*initDevice)(const char* name);
    void (*disableDevice)(HdHandle);
    void (*makeCurrent)(HdHandle);
    void (*beginFrame)(HdHandle);
    void (*endFrame)(HdHandle);
    HdErrorRecord (*getError)();
    void (*enable)(HdEnum);
    void (*disable)(HdEnum);
    void (*getIntegers)(HdEnum, std::int32_t*);
    void (*getDoubles)(HdEnum, double*);
    void (*setDoubles)(HdEnum, const double*);
    const char* (*getText)(HdEnum);
    HdEnum (*checkCalibration)();
    void (*updateCalibration)(HdEnum style);
    void (*startScheduler)();
    void (*stopScheduler)();
    void (*setSchedulerRate)(unsigned long hz);
    unsigned long (*schedule)(HdCallback, void* user, std::uint16_t priority);
    void (*unschedule)(unsigned long task);
};

/// The vendor's library, loaded into this process.
class HdLibrary {
public:
    /// `path`: a file, or a name that the system's loader finds. Fails with a sentence that states what to install.
    [[nodiscard]] static Expected<std::shared_ptr<const HdLibrary>> load(const std::string& path);
    /// Starts and stops a device of the library in a child process, unless an earlier trial succeeded. A library that
    /// crashes or hangs ends the child and not the program. Fails only in that case; a missing device is not an error
    /// here.
    [[nodiscard]] static Expected<void> probeLibrary(const std::string& path);
    /// $TACTOOTH_LIBHD, else libHD.so, on Windows HD.dll.
    [[nodiscard]] static std::string defaultPath();

    [[nodiscard]] const HdFunctions& call() const { return functions_; }

private:
    HdFunctions functions_{};
};

/// Explains an error code and the remedy in one sentence. The message lives as long as the program.
[[nodiscard]] const Message& hdErrorMessage(std::uint32_t code);

/// Whether the device can continue after this error.
[[nodiscard]] bool isHdErrorTransient(std::uint32_t code);

}  // namespace tactooth
