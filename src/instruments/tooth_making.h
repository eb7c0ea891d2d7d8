// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "instruments/builtin_tooth.h"

namespace tactooth {

/// The same tooth as makeTooth(request) makes. `progress`: called after each layer with the share of the work that is
/// done, 0..1; it may be empty.
[[nodiscard]] BuiltinTooth makeToothReporting(const ToothRequest& request, const std::function<void(double)>& progress);

}  // namespace tactooth
