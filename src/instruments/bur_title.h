// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "instruments/bur_catalogue.h"

namespace tactooth {

/// "Round diamond 801-014, 1.4 mm" in any language. `shape`: as data/burs.toml writes it; a shape without a row in
/// messages.h stays as it is. Of `bur`, the number, the material and the diameter are used.
[[nodiscard]] Message burTitle(std::string_view shape, const BurSpec& bur);

/// The shape of a head in any language: "Round", to group burs by.
[[nodiscard]] Message burKindTitle(BurKind kind);

}  // namespace tactooth
