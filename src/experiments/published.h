// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Published results of the dental simulator whose measurements 'tactooth reproduce' repeats: surface meshes of real
// teeth, AABB trees with GJK and EPA, a force-feedback arm. Only these numbers are known to us, most of them as the
// least and the greatest of a table.
namespace tactooth::published {

inline constexpr int kMinTriangles = 288;
inline constexpr int kMaxTriangles = 325312;

// Table 2 and Table 3: from the fewest to the most triangles.
inline constexpr double kShortestLoad = 79;   // ms
inline constexpr double kLongestLoad = 4406;  // ms
inline constexpr double kShortestDraw = 12;   // ms
inline constexpr double kLongestDraw = 183;   // ms

// Table 4: movements from 100 um down to 0.1 um at 6, 12, 25, 50 and 100 % of the triangles.
inline constexpr double kMinMovement = 0.5;        // um, noticed at every resolution
inline constexpr double kMinMovementCoarse = 0.1;  // um, noticed at 6 % and 12 % only
inline constexpr double kShortestForce = 1.6;      // us, time to compute a force
inline constexpr double kLongestForce = 11.9;      // us

// Fig. 11 and Figs. 15 to 17: the greatest speed of the tip with reliable depths.
inline constexpr double kReliableOnPatches = 100;  // mm/s, ten-patch object
inline constexpr double kReliableOnTeeth = 66;     // mm/s, teeth

/// Figs. 15 to 17: time to compute a force, us.
struct ForceTime {
    double slow;  ///< at low speed
    double fast;  ///< at high speed
};
inline constexpr ForceTime kAnteriorTooth{10, 8.1};
inline constexpr ForceTime kCanine{1.6, 2.6};
inline constexpr ForceTime kMolar{8.1, 11.9};

}  // namespace tactooth::published
