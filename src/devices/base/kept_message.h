// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

namespace tactooth {

/// A copy that lives as long as the program, as HapticDevice::faultMessage() needs it. Equal sentences share one copy;
/// there are few different ones. Any thread; takes a lock.
[[nodiscard]] const Message& keptMessage(const Message& message);

}  // namespace tactooth
