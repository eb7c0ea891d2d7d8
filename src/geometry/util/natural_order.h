// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace tactooth {

/// Whether a name comes before another, with numbers in them by value: "ann-2" before "ann-10".
[[nodiscard]] bool isNaturallyLess(std::string_view a, std::string_view b);

}  // namespace tactooth
