// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "devices/process/hand_process.h"

namespace tactooth {

/// The whole run of tactooth-hand: opens the device, and passes samples and forces until the program asks it to end, or
/// is gone. Returns the exit status.
[[nodiscard]] int runHand(const HandArguments& arguments);

}  // namespace tactooth
