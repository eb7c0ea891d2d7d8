// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/openhaptics/hd_library.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "devices/base/messages.h"
#include "devices/base/shared_library.h"

namespace tactooth {
namespace {

#ifdef _WIN32
constexpr const char* kDefaultName = "HD.dll";
#else
constexpr const char* kDefaultName = "libHD.so";
#endif

struct KnownError {
    std::uint32_t code;
    Message message;
};

// Made before any driver runs, whose thread only hands their places on.
const std::array<KnownError, 12> kErrors = {{
    {hd::kWarmMotors, msg::kHdMotorsWarm},
    {hd::kTooMuchForce, msg::kHdTooMuchForce},
    {hd::kTooMuchImpulse, msg::kHdTooMuchImpulse},
    {hd::kTooFast, msg::kHdTooFast},
    {hd::kForceError, msg::kHdForceError},
    {hd::kDeviceFault, msg::kHdDeviceFault},
    {hd::kAlreadyStarted, msg::kHdAlreadyStarted},
    {hd::kLinkFault, msg::kHdLinkFault},
    {hd::kLinkSettings, msg::kHdLinkSettings},
    {hd::kTimer, msg::kHdTimer},
    {hd::kSchedulerFull, msg::kHdSchedulerFull},
    {hd::kNoLicence, msg::kHdNoLicence},
}};
const Message kOtherError(msg::kHdOtherError);

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
        return unexpected(msg::kLibraryNotLoaded, path, library.error());
    }
    auto result = std::make_shared<HdLibrary>();
    if (const char* const missing = firstMissing(*library, result->functions_)) {
        return unexpected(msg::kLibraryLacksFunction, path, missing);
    }
    return std::shared_ptr<const HdLibrary>(std::move(result));
}

const Message& hdErrorMessage(std::uint32_t code) {
    const auto* const found = std::ranges::find(kErrors, code, &KnownError::code);
    return found == kErrors.end() ? kOtherError : found->message;
}

bool isHdErrorTransient(std::uint32_t code) { return code >= hd::kWarmMotors && code <= hd::kTooFast; }

}  // namespace tactooth
