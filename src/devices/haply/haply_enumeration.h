// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "devices/haply/haply_message.h"

namespace tactooth {

/// Who is there, as the service at `address` says. Fails with one sentence that says what to do.
[[nodiscard]] Expected<std::vector<HaplyNames>> enumerateHaply(const std::string& address);

}  // namespace tactooth
