// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The part of Tactooth that uses a pen, as a program for Windows: hd_dll_test STANDIN.dll LACKING.dll. It loads the
// stand-in for the vendor's HD.dll, presses on a plane, releases the pen and loses it. Exit code 0 on success.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>

#include "devices/base/monotonic_clock.h"
#include "devices/base/shared_library.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/openhaptics/openhaptics_device.h"
#include "haptics/force_pipeline.h"
#include "standin/standin_hd.h"

namespace tactooth {
namespace {

using test::HdFault;
using test::HdStandinControl;

int failures = 0;

void expect(bool holds, const std::string& what) {
    std::printf("%s: %s\n", holds ? "ok" : "FAILED", what.c_str());
    if (!holds) ++failures;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A servo loop in this thread, at the pen's rate, over a plane 2 mm below the start position.
class PlaneServo {
public:
    explicit PlaneServo(HapticDevice& device) : device_(device), pipeline_(patient(device.info().limits)) {}

    /// Runs ticks until the condition is true; false after a time limit that only a broken program exceeds.
    bool runUntil(const std::function<bool()>& isSo, double seconds = 60) {
        for (const double end = monotonicSeconds() + seconds; monotonicSeconds() < end;) {
            tick();
            if (isSo()) return true;
        }
        return false;
    }
    /// If the machine stalls, the device releases its force, which returns only after the tool has lifted off.
    bool lean(const HdStandinControl& pen) {
        const auto isPressed = [&] { return pen.forceOf(0) > 0.3; };
        for (int i = 0; i < 60; ++i) {
            pen.wantPosition(0, 5, 0);
            (void)runUntil([] { return false; }, 0.2);
            pen.wantPosition(0, -6, 0);
            if (runUntil(isPressed, 1)) return true;
        }
        return false;
    }

private:
    /// Under Wine no thread has real-time priority: on a busy machine half a second would rarely pass without a stall.
    static ForceLimits patient(ForceLimits limits) {
        limits.rampTime = 0.02;
        limits.tickTimeout = 0.1;
        return limits;
    }
    void tick() {
        device_.waitForTick(0.003);
        const double now = monotonicSeconds();
        const double elapsed = now - last_;
        last_ = now;
        const DeviceSample sample = device_.read(elapsed);
        ForceCommand wanted;
        wanted.connected = sample.connected;
        wanted.hand = sample.hand.position;
        wanted.deflection = std::max(0.0, -2 - sample.hand.position.z());
        wanted.touching = wanted.deflection > 0;
        wanted.stiffness = wanted.touching ? 0.4 : 0;
        wanted.wrench.force = Vec3(0, 0, 0.4 * wanted.deflection);
        device_.write(pipeline_.pass(wanted, elapsed));
    }

    HapticDevice& device_;
    ForcePipeline pipeline_;
    double last_ = monotonicSeconds();
};

/// Error text of opening the device; empty on success.
std::string openError(const std::string& library) {
    OpenHapticsDevice device("", library);
    const auto opened = device.open();
    return opened ? std::string() : opened.error().message();
}

bool says(const HapticDevice& device, const std::string& part) {
    return device.faultMessage() != nullptr && contains(device.faultMessage()->in(Language::English), part);
}

void leanAndLose(const std::string& library, const HdStandinControl& pen) {
    OpenHapticsDevice device("", library);
    expect(device.open().has_value(), "the pen opens");
    expect(device.info().name == "Touch (stand-in)" && device.info().limits.force == 3.3, "it reports what it is");
    PlaneServo servo(device);
    pen.wantPosition(0, 5, 0);
    expect(servo.runUntil([&] { return device.read(0).hand.position.z() > 4; }), "its hand is read");
    expect(servo.lean(pen), "the plane gives a force");
    pen.setButtons(3);
    expect(servo.runUntil([&] { return device.read(0).buttons == 3; }), "both buttons are read");
    expect(servo.lean(pen), "it gives a force again");
    pen.setFault(static_cast<int>(HdFault::LinkFault));
    expect(servo.runUntil([&] { return says(device, "check its cable") && pen.forceOf(0) == 0; }), "a loss is said");
    expect(pen.lastForceSinceFault() <= 3, "the force ended within two ticks");
    pen.setFault(static_cast<int>(HdFault::None));
    pen.wantPosition(0, 5, 0);
    expect(servo.runUntil([&] { return device.faultMessage() == nullptr; }), "it comes back");
    device.close();
    expect(pen.startedPens() == 0, "the pen is closed");
}

}  // namespace
}  // namespace tactooth

int main(int argc, char** argv) {
    using namespace tactooth;
    if (argc != 3) return 2;
    expect(HdLibrary::defaultPath() == "HD.dll", "the library has its name on Windows");
    expect(contains(openError("no_such.dll"), "no_such.dll cannot be loaded ("), "a missing library is said");
    expect(contains(openError(argv[2]), "has no function hd"), "another version is said");
    const auto library = loadSharedLibrary(argv[1]);
    expect(library.has_value(), "the stand-in loads");
    if (!library) return 1;
    const auto* const pen = static_cast<const HdStandinControl*>(findInLibrary(*library, "standinControl"));
    expect(pen != nullptr, "and has its own door");
    if (pen == nullptr) return 1;
    leanAndLose(argv[1], *pen);
    std::printf("%d failures\n", failures);
    std::fflush(stdout);
    return failures == 0 ? 0 : 1;
}
