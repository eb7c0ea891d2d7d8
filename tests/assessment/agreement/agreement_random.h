// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/agreement/seeded_random.h"

namespace tactooth::test {

/// A normal deviate, near enough: a sum of twelve uniform ones.
inline double normal(SeededRandom& random) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.share();
    return sum;
}

}  // namespace tactooth::test
