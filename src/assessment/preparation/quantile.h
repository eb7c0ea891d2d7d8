// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <iterator>
#include <ranges>

#include "geometry/util/assert.h"

namespace tactooth {

/// The first element of `sorted` with which the areas from the beginning reach `share` (0..1) of `area`, their sum;
/// the last one where rounding leaves a rest. `areaOf` gives the area of an element, mm^2. `sorted` is not empty.
template <std::ranges::random_access_range Range, class AreaOf>
[[nodiscard]] const auto& quantileByArea(const Range& sorted, double area, double share, AreaOf areaOf) {
    TACTOOTH_ASSERT(!std::ranges::empty(sorted));
    double below = 0;
    for (const auto& each : sorted) {
        below += std::invoke(areaOf, each);
        if (below >= share * area) return each;
    }
    return *std::prev(std::ranges::end(sorted));
}

}  // namespace tactooth
