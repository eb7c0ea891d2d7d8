// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tooth/model/material_registry.h"

namespace tactooth::test {

// The built-in materials: a test of the registry compares them with data/materials.toml.
inline constexpr MaterialId kEnamel{0}, kDentin{1}, kPulp{2}, kOther{3}, kRestoration{4}, kCaries{5};

}  // namespace tactooth::test
