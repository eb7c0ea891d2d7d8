// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/openhaptics/hd_library.h"

#include <algorithm>
#include <cstdlib>

#include "devices/base/shared_library.h"

namespace tactooth {
namespace {

#ifdef _WIN32
constexpr const char* kDefaultName = "HD.dll";
#else
constexpr const char* kDefaultName = "libHD.so";
#endif

struct ErrorText {
    std::uint32_t code;
    const char* text;
};

constexpr ErrorText kErrors[] = {
    {hd::kWarmMotors, "The motors are warm: rest the pen for a minute; until then the force is weaker."},
    {hd::kTooMuchForce, "The driver has cut a force that was too strong; press more gently."},
    {hd::kTooMuchImpulse, "The driver has cut a force that rose too fast; move the pen more slowly into the tooth."},
    {hd::kTooFast, "The pen was moved faster than its driver allows; the force comes back by itself."},
    {hd::kForceError, "The driver reports a force error: switch the device off and on again."},
    {hd::kDeviceFault,
     "The device reports a fault: check its power supply and cable, then switch it off and on again."},
    {hd::kAlreadyStarted, "The device is in use: close the other program that holds it."},
    {hd::kLinkFault, "The device does not answer: check its cable and power supply; it is tried again every second."},
    {hd::kLinkSettings, "The device is not set up: run the vendor's setup program and pair it."},
    {hd::kTimer, "The driver's timer does not run: start the vendor's service, or restart the computer."},
    {hd::kSchedulerFull, "The driver takes no more work: close other programs that use the device."},
    {hd::kNoLicence, "The vendor's library finds no licence: install OpenHaptics with its licence."},
};

template <class Function>
bool find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(findInLibrary(library, name));
    return function != nullptr;
}

/// The name of the first function that is missing; nullptr if all are there.
const char* firstMissing(void* library, HdFunctions& f) {
    const char* missing = nullptr;
    const auto take = [&](const char* name, auto& function) {
        if (!find(library, name, function) && missing == nullptr) missing = name;
    };
    take("hdInitDevice", f.initDevice);
    take("hdDisableDevice", f.disableDevice);
    take("hdMakeCurrentDevice", f.makeCurrent);
    take("hdBeginFrame", f.beginFrame);
    take("hdEndFrame", f.endFrame);
    take("hdGetError", f.getError);
    take("hdEnable", f.enable);
    take("hdDisable", f.disable);
    take("hdGetIntegerv", f.getIntegers);
    take("hdGetDoublev", f.getDoubles);
    take("hdSetDoublev", f.setDoubles);
    take("hdGetString", f.getText);
    take("hdCheckCalibration", f.checkCalibration);
    take("hdUpdateCalibration", f.updateCalibration);
    take("hdStartScheduler", f.startScheduler);
    take("hdStopScheduler", f.stopScheduler);
    take("hdSetSchedulerRate", f.setSchedulerRate);
    take("hdScheduleAsynchronous", f.schedule);
    take("hdUnschedule", f.unschedule);
    return missing;
}

}  // namespace

std::string HdLibrary::defaultPath() {
    const char* const own = std::getenv("TACTOOTH_LIBHD");
    return own != nullptr && *own != 0 ? own : kDefaultName;
}

Expected<std::shared_ptr<const HdLibrary>> HdLibrary::load(const std::string& path) {
    const Expected<void*> library = loadSharedLibrary(path);
    if (!library) {
        return unexpected(path + " cannot be loaded (" + library.error().message +
                          "): install the device's driver and OpenHaptics, or set TACTOOTH_LIBHD to the library.");
    }
    auto result = std::make_shared<HdLibrary>();
    if (const char* const missing = firstMissing(*library, result->functions_)) {
        return unexpected(path + " has no function " + missing +
                          ": it is another version; install OpenHaptics 3.4 or newer.");
    }
    return std::shared_ptr<const HdLibrary>(std::move(result));
}

const char* hdErrorText(std::uint32_t code) {
    const auto found = std::ranges::find(kErrors, code, &ErrorText::code);
    return found == std::end(kErrors)
               ? "The device's driver reports an error: switch the device off and on again and restart Tactooth."
               : found->text;
}

bool isHdErrorTransient(std::uint32_t code) { return code >= hd::kWarmMotors && code <= hd::kTooFast; }

}  // namespace tactooth
