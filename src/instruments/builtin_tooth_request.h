// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/builtin_tooth.h"

namespace tactooth {

/// What makeBuiltinTooth with the same arguments makes: makeTooth of this is the same, bit for bit.
[[nodiscard]] ToothRequest builtinToothRequest(BuiltinToothKind kind, int triangles = 20000,
                                               double lesionWidth = kDefaultLesionWidth);

}  // namespace tactooth
