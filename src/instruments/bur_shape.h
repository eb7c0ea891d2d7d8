// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"
#include "instruments/bur_catalogue.h"

namespace tactooth {

/// A bur as a body. Tool frame: origin at the tip, +z along the shaft away from the tip, mm.
struct Bur {
    BurSpec spec;
    TriangleMesh surface;  ///< closed; head with its blades, neck and the visible part of the shank
};

/// Default resolution of a bur: that of a bur for contact at 1 kHz, a few hundred triangles.
inline constexpr int kContactBurTriangles = 340;

/// Diameter of a friction-grip shank, mm (ISO 1797, type 3).
inline constexpr double kShankDiameter = 1.6;

/// The bur of a catalogue entry, with about `triangles` triangles (at least about two hundred: fewer cannot show a
/// blade). Blade edges are on the surface of revolution of the head, all else on or inside it.
[[nodiscard]] Bur makeBur(const BurSpec& spec, int triangles = kContactBurTriangles);

/// The same with exactly `triangles` triangles, or one fewer if that is odd: a closed surface has an even number.
/// Missing triangles are split off along the shank, whose shape stays. It has more triangles if so few cannot show a
/// blade.
[[nodiscard]] Bur makeBurWithTriangles(const BurSpec& spec, int triangles);

}  // namespace tactooth
