// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/util/vec.h"

namespace tactooth {

/// The walls of a ghost are coloured in steps by the tooth that lies before them along the line of sight.
inline constexpr double kGhostStep = 0.5;  // mm

/// The colours, sRGB: of less than one step, less than two, and so on; the last one is for all that is deeper. They
/// become darker from step to step, so that they differ for all kinds of colour blindness.
inline const std::array<Vec3f, 5> kGhostColours = {Vec3f{0.62F, 0.93F, 0.86F}, Vec3f{0.45F, 0.81F, 0.93F},
                                                   Vec3f{0.32F, 0.67F, 0.91F}, Vec3f{0.22F, 0.52F, 0.84F},
                                                   Vec3f{0.12F, 0.38F, 0.74F}};

}  // namespace tactooth
