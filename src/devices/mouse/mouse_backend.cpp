// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/mouse/mouse_backend.h"

#include "devices/base/messages.h"
#include "devices/mouse/mouse_device.h"
#include "devices/probe/device_probe.h"

namespace tactooth {
namespace {

std::vector<DetectedDevice> probeMouse() {
    return {{"mouse", "mouse and keyboard", DeviceState::Ready,
             "always there; no force: what the hand would feel is shown", capabilitiesOf(MouseDevice(Pose()).info())}};
}

}  // namespace

DeviceBackend mouseBackend() { return {"mouse", msg::kMouseAndKeyboard, nullptr, nullptr, nullptr, probeMouse}; }

}  // namespace tactooth
