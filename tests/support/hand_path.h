// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/hand_path.h"

namespace tactooth::test {

using tactooth::HandPath;
using tactooth::handPath;

}  // namespace tactooth::test
