// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

#include "devices/base/haptic_device.h"
#include "devices/process/bell.h"
#include "devices/process/hand_fault.h"
#include "devices/process/shared_slots.h"

// The layout of the memory that the program and tactooth-hand share. Both map it, and neither trusts what it reads
// there. Any change of a struct needs a new kHandLinkVersion. Times are s of the monotonic clock, which all processes
// share; lengths are mm, forces N.

namespace tactooth {

/// A force of the program.
struct ForceMessage {
    std::uint32_t sequence = 0;  ///< counts the forces, and wraps around
    std::uint32_t answers = 0;   ///< PoseMessage::sequence of the pose that it was computed from
    double sentAt = 0;
    std::array<double, 3> force{};
    std::array<double, 3> torque{};
    std::uint32_t endSequence = 0;  ///< equals `sequence`, unless the message is half written
    std::uint32_t unused = 0;
};

/// A sample of the device, and what became of the program's forces.
struct PoseMessage {
    std::uint32_t sequence = 0;   ///< counts the messages, and wraps around
    std::uint32_t freshness = 0;  ///< counts the samples that the device measured anew
    double publishedAt = 0;
    double measuredAt = 0;
    std::array<double, 3> position{};
    std::array<double, 4> rotation{1, 0, 0, 0};  ///< w, x, y, z
    double pedal = 0;
    double motorTemperature = 0;
    std::uint32_t buttons = 0;
    std::uint32_t connected = 0;
    HandFault fault = HandFault::None;  ///< for which the program must start its force anew
    std::uint32_t applied = 0;          ///< sequence of the last force that went to the device
    double forceDelay = 0;              ///< s from the program's write to the device's, of that force
    double roundTrip = 0;  ///< s from the arrival of the sample to the force that answers it, of that force
    std::uint32_t endSequence = 0;
    std::uint32_t unused = 0;
};

/// One sentence in both languages. An empty one means that there is none.
struct HandText {
    std::array<char, 1024> english{};
    std::array<char, 1024> japanese{};
};

/// DeviceInfo in a fixed layout.
struct DeviceDescription {
    std::array<char, 256> name{};
    ForceLimits limits;
    PoseLimits poseLimits;
    std::array<double, 3> workspace{};
    std::array<double, 3> workspaceCentre{};
    double stiffness = 0;
    std::int32_t buttonCount = 0;
    std::uint32_t hasWorkspaceCentre = 0;
    std::uint32_t rendersForce = 0;
    std::uint32_t sensesRotation = 0;
    std::uint32_t hasPedal = 0;
    std::uint32_t isInToothFrame = 0;
    std::uint32_t drivesServoRate = 0;
    std::uint32_t unused = 0;
};

enum class HandStatus : std::uint32_t {
    Starting,
    Open,    ///< the device is open, `description` is valid
    Failed,  ///< `failure` says why it is not
};

inline constexpr std::uint64_t kHandLinkMagic = 0x444E414854435454;  // "TTCTHAND"
inline constexpr std::uint32_t kHandLinkVersion = 1;

struct HandLink {
    std::uint64_t magic = kHandLinkMagic;
    std::uint32_t version = kHandLinkVersion;
    std::uint32_t bytes = static_cast<std::uint32_t>(sizeof(HandLink));

    std::atomic<HandStatus> status{HandStatus::Starting};
    std::atomic<std::uint32_t> endRequested{0};    ///< by the program: close the device and end
    std::atomic<std::uint32_t> inputSuspended{0};  ///< see HapticDevice::suspendInput
    /// The loop of the hand process has a higher real-time priority than a servo. So both may share a processor, where
    /// they wake each other several times faster than from one processor to another, and the loop still comes first.
    std::atomic<std::uint32_t> mayShareProcessor{0};
    std::atomic<std::int32_t> servoProcessor{-1};  ///< that the program's servo thread keeps to; -1: to none
    DeviceDescription description;                 ///< written before `status`
    HandText failure;                              ///< likewise

    alignas(64) Bell handBell;     ///< the hand process sleeps on it: a force, a sample, a request
    alignas(64) Bell programBell;  ///< the program sleeps on it: a fresh sample, a new status
    SharedSlots<PoseMessage> poses;
    SharedSlots<ForceMessage> forces;
    SharedSlots<HandText> faults;  ///< HapticDevice::faultMessage of the device
};
static_assert(std::is_trivially_copyable_v<DeviceDescription> && std::atomic<HandStatus>::is_always_lock_free);

/// Whether the other side was built with the same layout.
[[nodiscard]] inline bool hasSameLayout(const HandLink& link) {
    return link.magic == kHandLinkMagic && link.version == kHandLinkVersion && link.bytes == sizeof(HandLink);
}

/// Whether `next` follows `last` by `most` at most, in a count that wraps around.
[[nodiscard]] inline bool follows(std::uint32_t next, std::uint32_t last, std::uint32_t most) {
    return next - last - 1 < most;
}

[[nodiscard]] DeviceDescription descriptionOf(const HapticDevice& device);
/// None if it holds a limit that no device has.
[[nodiscard]] std::optional<DeviceInfo> infoFrom(const DeviceDescription& description);

/// Texts that are too long lose their end.
[[nodiscard]] HandText handTextOf(const Message& message);
/// None if the text is empty.
[[nodiscard]] std::optional<Message> messageFrom(const HandText& text);

/// Without sequence, times and what became of the forces.
[[nodiscard]] PoseMessage poseMessageOf(const DeviceSample& sample);
/// Without age and `isFresh`.
[[nodiscard]] DeviceSample sampleFrom(const PoseMessage& message);

/// Without sequence and times.
[[nodiscard]] ForceMessage forceMessageOf(const SafeWrench& wrench);
[[nodiscard]] Wrench wrenchFrom(const ForceMessage& message);

}  // namespace tactooth
