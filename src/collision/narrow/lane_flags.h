// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/narrow/simd8.h"

// A flag states in which of eight lanes a condition holds: 1 where it does, 0 elsewhere. The product of two flags is
// "and", their difference "and not".

namespace tactooth {

inline Float8 zero8() { return Float8::all(0); }
inline Float8 one8() { return Float8::all(1); }

[[nodiscard]] inline Float8 isLess(Float8 a, Float8 b) { return whereLess(a, b, one8(), zero8()); }
[[nodiscard]] inline bool isAny(Float8 flags) { return lessEqual(one8(), flags) != 0; }

/// Lane by lane: flag ? yes : no.
[[nodiscard]] inline Float8 choose(Float8 flag, Float8 yes, Float8 no) { return whereLess(zero8(), flag, yes, no); }
[[nodiscard]] inline Vec3x8 choose(Float8 flag, const Vec3x8& yes, const Vec3x8& no) {
    return {choose(flag, yes.x, no.x), choose(flag, yes.y, no.y), choose(flag, yes.z, no.z)};
}

}  // namespace tactooth
