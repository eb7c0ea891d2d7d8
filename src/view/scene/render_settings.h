// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// How the shadow of the operating light is drawn.
enum class Shadows {
    None,
    Hard,      ///< edges as soft as three texels of the shadow map
    Soft,      ///< a penumbra of the same width everywhere
    Widening,  ///< a penumbra that widens with the distance of what throws the shadow, as of a real operating light
};

/// The permitted cost of a picture.
struct RenderSettings {
    int samples = 0;  ///< per pixel, against jagged edges, 0 or 2..8; fewer if the driver supports fewer
    Shadows shadows = Shadows::Hard;
    bool ambientOcclusion = false;  ///< darkened fissures and contacts

    /// Smooths jagged edges in the finished picture, if it has one sample per pixel.
    bool antialiasing = false;
    double resolution = 1;  ///< share of the pixels drawn along each side, 0..1; the rest is interpolated

    /// Pixels by which a drawn surface may deviate, so that distant or small objects need fewer triangles. 0 draws
    /// every triangle.
    double lodTolerance = 0;

    bool operator==(const RenderSettings&) const = default;
};
/// The least: edges are jagged.
inline constexpr RenderSettings kQuick{.lodTolerance = 0.5};
/// While things move: on a computer without a graphics card, and with one.
inline constexpr RenderSettings kMoving{.antialiasing = true, .lodTolerance = 0.5};
inline constexpr RenderSettings kSmooth{.samples = 4, .shadows = Shadows::Soft, .lodTolerance = 0.5};
/// At rest.
inline constexpr RenderSettings kFine{.samples = 4, .shadows = Shadows::Widening, .ambientOcclusion = true};

}  // namespace tactooth
