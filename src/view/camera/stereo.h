// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "view/camera/camera.h"

namespace tactooth {

/// How a picture shows depth to two eyes.
struct Stereo {
    enum class Mode {
        Off,
        SideBySide,  ///< the left eye's picture on the left half, for goggles and crossed screens
        Anaglyph,    ///< for red (left) and cyan glasses
    };
    Mode mode = Mode::Off;
    double focus = 60;      ///< mm in front of the eyes: points at this distance appear in the plane of the screen
    double separation = 2;  ///< mm between the eyes; a thirtieth of `focus` is comfortable

    bool operator==(const Stereo&) const = default;
};

/// The cameras of the left and the right eye on both sides of `camera`. Their viewing directions are parallel; their
/// pictures are shifted so that they agree at `stereo.focus` (no keystone, no vertical parallax).
[[nodiscard]] std::array<Camera, 2> stereoCameras(const Camera& camera, const Stereo& stereo);

}  // namespace tactooth
