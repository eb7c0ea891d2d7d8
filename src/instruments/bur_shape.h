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

/// Fineness of a bur's surface by default: as that of a bur used for contact at 1 kHz, a few hundred triangles.
inline constexpr int kContactBurTriangles = 340;

/// Diameter of a friction-grip shank, mm (ISO 1797, type 3).
inline constexpr double kShankDiameter = 1.6;

/// The bur of a catalogue line, with about `triangles` triangles (at least some two hundred: fewer do not show a
/// blade). Blade edges lie on the head's surface of revolution, everything else on or inside it.
[[nodiscard]] Bur makeBur(const BurSpec& spec, int triangles = kContactBurTriangles);

/// The same with just `triangles` of them, or one fewer where that is odd: a closed surface has an even number. What is
/// missing to it is split off along the shank, whose shape stays. More than asked for where fewer show no blade.
[[nodiscard]] Bur makeBurWithTriangles(const BurSpec& spec, int triangles);

}  // namespace tactooth
