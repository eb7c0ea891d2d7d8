// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/util/pose.h"

namespace tactooth {

/// How the mouth mirror was held and from where it was looked at, on the grid of TickInput. The simulation knows
/// nothing of it.
struct MirrorSight {
    bool isShown = false;                    ///< in the picture; what follows is zero without it
    std::array<std::int64_t, 3> position{};  ///< of the glass's centre in the tooth frame, in steps
    std::array<std::int32_t, 4> rotation{};  ///< x, y, z, w, in steps; the glass faces +z
    std::int64_t radius = 0;                 ///< of the glass, in steps of a position
    std::array<std::int64_t, 3> eye{};       ///< in the tooth frame, in steps

    /// `mirror`: the glass's centre, facing +z, in the tooth frame. `radius` in mm. A pose or eye that is not on the
    /// grid is not shown.
    [[nodiscard]] static MirrorSight of(const Pose& mirror, double radius, const Vec3& eye);
    /// mm
    [[nodiscard]] Pose mirror() const;
    [[nodiscard]] double radiusMm() const;
    [[nodiscard]] Vec3 eyePlace() const;
    /// Whether the eye sees `place` in the glass: the line of sight that the glass reflects meets it. What lies between
    /// is not looked at.
    [[nodiscard]] bool shows(const Vec3& place) const;

    friend bool operator==(const MirrorSight&, const MirrorSight&) = default;
};

/// From a tick on, until the next one, the mirror was held so.
struct MirrorMoment {
    std::uint64_t tick = 0;  ///< number of ticks of the recording before it
    MirrorSight sight;

    friend bool operator==(const MirrorMoment&, const MirrorMoment&) = default;
};

/// The payload of a block of the type mirror (docs/session-file.md).
[[nodiscard]] std::vector<std::byte> encodeMirror(std::span<const MirrorMoment> moments);
/// Reads what encodeMirror wrote; nothing for anything else.
[[nodiscard]] std::optional<std::vector<MirrorMoment>> decodeMirror(std::span<const std::byte> payload);

}  // namespace tactooth
