// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "session/recording/mirror_sight.h"

// How the mirror was held in the course of a recording. All moments are in the order of their ticks.

namespace tactooth {

/// How it was held after so many ticks; not shown where the recording does not say it.
[[nodiscard]] MirrorSight sightAt(std::span<const MirrorMoment> moments, std::uint64_t ticks);

/// The eye that first saw the mirror, tooth frame; none where the recording does not say it. In a mirror another eye
/// sees something else.
[[nodiscard]] std::optional<Vec3> firstEye(std::span<const MirrorMoment> moments);

}  // namespace tactooth
