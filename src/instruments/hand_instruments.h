// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/message.h"
#include "instruments/modelling/surface_of_revolution.h"

namespace tactooth {

/// An explorer No. 23, the shepherd's hook, as a closed surface: origin at the tip, which points toward -x, the handle
/// along +z; mm.
[[nodiscard]] TriangleMesh makeExplorer();

/// A probe's marks, mm from the tip (Williams).
inline constexpr std::array<double, 8> kProbeMarks = {1, 2, 3, 5, 7, 8, 9, 10};

/// A periodontal probe with a ring at each mark, as a closed surface: origin at the blunt tip (0.5 mm), the marked end
/// along +z, the handle leaving toward +x; mm.
[[nodiscard]] TriangleMesh makePeriodontalProbe();

/// A spoon excavator as a closed surface: origin at the end of its round spoon, the spoon along +z with its hollow
/// toward -y, the handle leaving toward +x; mm.
[[nodiscard]] TriangleMesh makeSpoonExcavator();

/// Largest radius of the spoon, mm.
inline constexpr double kSpoonRadius = 0.6;

/// What somebody holds in the hand instead of a handpiece.
enum class HandInstrument : std::uint8_t {
    Explorer,  ///< touches; its tip sticks in soft decay
    Probe,     ///< touches, and reads depths
    Excavator  ///< takes soft decay away, without a drive
};

/// A row of the list of hand instruments.
struct HandInstrumentSpec {
    HandInstrument kind;
    std::string_view name;     ///< in files and on the command line
    const MessageText* title;  ///< for people
    double headLength;         ///< of the part that works, from the tip along +z, mm
    double headRadius;         ///< of that part, mm
};
[[nodiscard]] std::span<const HandInstrumentSpec> handInstruments();
[[nodiscard]] const HandInstrumentSpec& specOf(HandInstrument kind);
/// By its name, or by its English title; null: there is none.
[[nodiscard]] const HandInstrumentSpec* findHandInstrument(std::string_view nameOrTitle);

/// The instrument as the hand holds it over a tooth, for pictures: tip at the origin and lowest, the working end along
/// +z or aslant, the handle leaving toward +x; mm.
[[nodiscard]] TriangleMesh heldInstrument(HandInstrument kind);
/// The same without its handle, and with the few triangles that contact at 1 kHz allows.
[[nodiscard]] TriangleMesh touchingInstrument(HandInstrument kind);

/// What the spoon sweeps as the fingers roll it, from its end up to the neck, in the same frame.
[[nodiscard]] std::vector<OutlinePoint> spoonOutline();

}  // namespace tactooth
