// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace tactooth {

/// Cost of a move: about nanoseconds of one core (AMD EPYC, 2.6 GHz). It is counted, not timed, so that equal runs stay
/// equal on any machine.
using Work = std::int64_t;

inline constexpr Work kUnlimitedWork = std::numeric_limits<Work>::max();

/// Costs of the parts of a move, rounded from least-squares fits to 7,000 measured ticks of burs of 0.5 to 2.3 mm in
/// the cavity that they cut. (To build a list is rare in such a tick; its cost was measured separately.)
namespace cost {
inline constexpr Work kList = 4000;      // to begin a neighbour list
inline constexpr Work kNodeMet = 80;     // to open a node of the tooth's tree for a list
inline constexpr Work kLeafMet = 130;    // to open a leaf for a list
inline constexpr Work kListed = 200;     // to add a cluster to a list
inline constexpr Work kSolution = 1000;  // to solve the QP
inline constexpr Work kPacket = 10;      // to test eight clusters
inline constexpr Work kCluster = 25;     // to open an uncertain cluster
inline constexpr Work kPair = 50;        // to test a pair in double precision
inline constexpr Work kDistance = 1000;  // to run GJK
}  // namespace cost

}  // namespace tactooth
