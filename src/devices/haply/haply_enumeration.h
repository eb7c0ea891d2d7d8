// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "devices/haply/haply_message.h"

namespace tactooth {

/// The devices that the service at `address` lists. Fails with one sentence that states the remedy.
[[nodiscard]] Expected<std::vector<HaplyNames>> enumerateHaply(const std::string& address);

}  // namespace tactooth
