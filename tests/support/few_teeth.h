// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace tactooth::test {

/// FDI numbers of the missing teeth when only these are left: such a mouth takes a fraction of the time.
inline std::vector<int> allTeethExcept(std::initializer_list<int> left) {
    std::vector<int> missing;
    for (const int quadrant : {10, 20, 30, 40}) {
        for (int place = 1; place <= 8; ++place) {
            if (std::ranges::find(left, quadrant + place) == left.end()) missing.push_back(quadrant + place);
        }
    }
    return missing;
}

}  // namespace tactooth::test
