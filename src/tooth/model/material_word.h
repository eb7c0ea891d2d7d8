// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "geometry/util/message.h"

namespace tactooth {

/// The word for a material, by its name in files ("enamel"), for people of either language; any other name stays as it
/// is.
[[nodiscard]] Message materialWord(std::string_view name);

}  // namespace tactooth
