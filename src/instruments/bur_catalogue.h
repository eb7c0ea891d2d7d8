// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/message.h"

namespace tactooth {

/// The shape of a bur's head. "Taper" widens toward the shank.
enum class BurKind {
    Round,            ///< a ball, cut off where the blades end
    InvertedCone,     ///< a flat end, narrowing toward the shank
    StraightFissure,  ///< a cylinder with a flat end
    DomeFissure,      ///< a cylinder with a round end
    TaperedFissure,   ///< a flat-ended taper
    RoundEndTaper,    ///< a round-ended taper
    Pear,             ///< a rounded end, narrowing toward the shank
    Flame,            ///< a pointed bud
    Football,         ///< an egg
    Torpedo,          ///< a cylinder, or a slight taper, with a pointed arch for its end
    Needle,           ///< a long cone with a fine rounded point
    Wheel             ///< a disc with rounded edges
};

enum class BurMaterial { Carbide, Diamond };

/// The cutting part of a bur.
struct BurEdge {
    int flutes = 6;              ///< blades; 0 for a diamond
    double gritMicrometres = 0;  ///< of a diamond: mean grain size
};

/// One entry of the catalogue, as a dentist orders it. Lengths in mm.
struct BurSpec {
    std::string number;  ///< US number ("4"), or the manufacturer's shape and ISO size of a diamond ("856-016")
    std::string name;    ///< name in English, for lists and files
    Message title;       ///< the name in any language; empty for a bur that is not of the catalogue
    BurKind kind = BurKind::Round;
    BurMaterial material = BurMaterial::Carbide;
    double headDiameter = 1;     ///< the largest diameter of the head
    double headLength = 1;       ///< from the tip to the end of the blades or of the grit
    double taperDegrees = 0;     ///< full cone angle, positive where the head widens toward the shank
    int flutes = 6;              ///< number of blades; 0 for a diamond
    int contactFlutes = 0;       ///< blades of the coarse mesh that feels the tooth; 0: as many as `flutes`
    double sharpness = 1;        ///< cutting ability: 1 as new, 0 does not cut
    int isoShape = 1;            ///< third group of the ISO 6360 number
    bool crossCut = false;       ///< blades with notches
    double gritMicrometres = 0;  ///< of a diamond: mean grain size; 0 for a carbide

    [[nodiscard]] BurEdge edge() const { return {flutes, gritMicrometres}; }
};

/// All burs that the program can generate, in the order of a list.
[[nodiscard]] const std::vector<BurSpec>& burCatalogue();

/// The bur with this number, if the catalogue has it: a US or manufacturer's number like `BurSpec::number`, or an ISO
/// 6360 number of 15 digits, with or without spaces. The grit of a diamond's ISO number (494 super-fine to 544
/// super-coarse) may differ from the medium grit of the catalogue.
[[nodiscard]] std::optional<BurSpec> findBur(std::string_view number);

/// The bur's ISO 6360 number, "500 314 001 001 014": material, shank and length, shape, toothing or grit, diameter.
[[nodiscard]] std::string isoNumber(const BurSpec& spec);

}  // namespace tactooth
