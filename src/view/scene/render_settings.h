// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// How the shadow of the operating light is drawn.
enum class Shadows {
    None,
    Hard,  ///< one lookup a pixel
    Soft,  ///< the penumbra of a real operating light
};

/// What a picture may cost.
struct RenderSettings {
    int samples = 0;  ///< per pixel against jagged edges, 0 or 2..8; less if the driver has less
    Shadows shadows = Shadows::Hard;
    bool ambientOcclusion = false;  ///< darkened fissures and contacts
    double resolution = 1;          ///< share of the pixels along each side that are drawn; the rest is filled in, 0..1

    /// Pixels by which a surface may be drawn off its place, so that what is far or small takes fewer triangles; 0
    /// draws every triangle.
    double lodTolerance = 0;

    bool operator==(const RenderSettings&) const = default;
};
/// While things move, on a computer without a graphics card, and with one.
inline constexpr RenderSettings kQuick{.lodTolerance = 0.5};
inline constexpr RenderSettings kSmooth{.samples = 4, .shadows = Shadows::Soft, .lodTolerance = 0.5};
/// At rest.
inline constexpr RenderSettings kFine{.samples = 4, .shadows = Shadows::Soft, .ambientOcclusion = true};

}  // namespace tactooth
