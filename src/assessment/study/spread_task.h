// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/study/hand_route.h"

namespace tactooth {

/// The same work with a wider outline: places of the outline lie `wider` mm farther outside, to the sides and beyond
/// the ends of the paths, and those inside stay. Beside a path that stands alone the bur goes there and back, and
/// around a lone place.
[[nodiscard]] HandTask spreadTask(const HandTask& task, double wider);

/// The same work with an end left out: the last `share` of the length of `whole` along its longest direction, at the
/// side where its last path ends. Work without a length is that share less deep.
[[nodiscard]] HandTask shortenedTask(const HandTask& task, const HandTask& whole, double share);

}  // namespace tactooth
