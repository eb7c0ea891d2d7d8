// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <system_error>

#include "geometry/util/message.h"

namespace tactooth {

/// Why the system refused something, as a part of a sentence. `reason`: an errno. Reasons without a row of the
/// catalogue stay in the words of the system.
[[nodiscard]] Message systemReason(int reason);
[[nodiscard]] Message systemReason(const std::error_code& reason);

}  // namespace tactooth
