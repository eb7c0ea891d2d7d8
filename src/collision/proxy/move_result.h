// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "collision/neighbours/work_cost.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// How a move ended.
enum class MoveStatus {
    Reached,          ///< the proxy stands at the goal
    InContact,        ///< contacts hold the proxy as near to the goal as they allow
    OutOfIterations,  ///< the limit of iterations came first; the pose is free and the next move continues from it
    OutOfBudget,      ///< the work budget came first, see ProxySolver::setBudget; likewise
    Overlapping,      ///< the start pose was not free (a surface was changed under the proxy)
};

/// In what the proxy may differ from the goal while contacts hold it.
enum class Freedom {
    Translation,  ///< 3 degrees: in position only; the orientation follows the goal as far as the tooth allows
    TranslationAndRotation,  ///< 6 degrees: in position and orientation, for devices that render torque
};

/// The most contacts that can hold a proxy at once: one for each degree of freedom.
inline constexpr int kMaxHeld = 6;

/// A contact point: a pair of triangles that holds the proxy.
struct ProxyContact {
    Vec3 normal;          ///< unit, from the tooth to the tool, in the tooth's frame
    Vec3 point;           ///< on the tool, in the tooth's frame, mm
    double multiplier;    ///< mm, never negative: the shift of the tool's centre from goal to pose is the sum of all
                          ///< multipliers times normals
    std::uint32_t part;   ///< 0 = base of the surface, i + 1 = patch i
    std::uint32_t tooth;  ///< triangle of that part
};

/// What one move did.
struct MoveResult {
    MoveStatus status = MoveStatus::Reached;
    int iterations = 0;  ///< linearisations
    int distances = 0;   ///< GJK runs
    Work work = 0;       ///< counted cost of the move
    int contactCount = 0;
    std::array<ProxyContact, kMaxHeld> contacts{};  ///< the first `contactCount` are valid
};

}  // namespace tactooth
