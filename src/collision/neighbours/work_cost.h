// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace tactooth {

/// What a move costs: about nanoseconds of one core (AMD EPYC, 2.6 GHz). Counted, not timed, so that equal runs stay
/// equal on any machine.
using Work = std::int64_t;

inline constexpr Work kUnlimitedWork = std::numeric_limits<Work>::max();

/// Of the parts of a move: rounded from least-squares fits to 7,000 measured ticks of burs of 0.5 to 2.3 mm in the
/// cavity that they cut. (What leads to a list's end is seldom in such a tick, and keeps what it once was measured at.)
namespace cost {
inline constexpr Work kList = 4000;    // making a list,
inline constexpr Work kNodeMet = 80;   // for each node of the tooth's tree that the search looks into,
inline constexpr Work kLeafMet = 130;  // each leaf
inline constexpr Work kListed = 200;   // and each cluster found
inline constexpr Work kSolution = 1000;
inline constexpr Work kPacket = 10;      // looking over eight clusters,
inline constexpr Work kCluster = 25;     // opening one in doubt,
inline constexpr Work kPair = 50;        // a pair of it in double precision,
inline constexpr Work kDistance = 1000;  // and GJK
}  // namespace cost

}  // namespace tactooth
