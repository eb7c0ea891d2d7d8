// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/simulated/null_device.h"

namespace tactooth {

NullDevice::NullDevice(const Pose& rest) : rest_(rest) { info_.name = "no device"; }

DeviceSample NullDevice::read(double) { return {rest_, 0, 0, true}; }

void NullDevice::write(const SafeWrench&) {}

}  // namespace tactooth
