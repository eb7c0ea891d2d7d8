// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactooth {

/// The name in the vendor's setup program of the pen that HDAPI starts without a name.
inline constexpr std::string_view kDefaultPen = "Default Device";

/// The names of the pens that are configured in the vendor's setup program: the default one first, the others sorted.
/// HDAPI has no list of them; they are the files NAME.config in $GTDD_HOME/config, else in the driver's usual folder.
/// Empty if that folder does not exist or cannot be read.
[[nodiscard]] std::vector<std::string> configuredPens();

}  // namespace tactooth
