// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <variant>

#include "assessment/exercise.h"

/// Words and bounds of the file of an exercise, for its reader, its writer and the editor.
namespace tactooth {

/// Their names in files, in the order of the enumerations.
inline constexpr std::array<std::string_view, 10> kGroupKeys = {
    "hand-eye", "caries", "filling", "class-1", "class-2", "class-3", "class-5", "crown", "endodontic", "own"};
inline constexpr std::array<std::string_view, 8> kViewKeys = {"cavity", "dentist", "mirror", "occlusal",
                                                              "buccal", "lingual", "mesial", "distal"};
/// What a cavity removes, and the role of its material; a filling has none.
inline constexpr std::array<std::pair<std::string_view, MaterialRole>, 3> kBodyKeys = {
    {{"caries", MaterialRole::Decay}, {"pulp", MaterialRole::Pulp}, {"filling", MaterialRole::None}}};
/// In the order of the tray.
inline constexpr std::array<std::pair<std::string_view, TrayInstrument>, 6> kInstrumentKeys = {
    {{"turbine", HandpieceKind::Turbine},
     {"contra-angle", HandpieceKind::ContraAngle},
     {"low-speed", HandpieceKind::LowSpeed},
     {"explorer", HandInstrument::Explorer},
     {"probe", HandInstrument::Probe},
     {"excavator", HandInstrument::Excavator}}};
inline constexpr std::array<std::string_view, 3> kLevelKeys = {"easy", "usual", "hard"};
inline constexpr std::array<std::pair<std::string_view, LesionSite>, 5> kSiteKeys = {
    {{"occlusal", LesionSite::Occlusal},
     {"mesial", LesionSite::Mesial},
     {"distal", LesionSite::Distal},
     {"buccal", LesionSite::Buccal},
     {"lingual", LesionSite::Lingual}}};

inline constexpr double kFarthest = 500;                             // mm from the origin of the tooth's frame
inline constexpr double kMinDepth = 0.05;                            // mm: a voxel
inline constexpr double kMaxDepth = 15;                              // mm: more than a crown is high
inline constexpr double kDeepestLesion = 10;                         // mm
inline constexpr double kMaxBox = 6;                                 // mm: any measure of a proximal box
inline constexpr double kMostTaper = 30;                             // degrees: more is no wall
inline constexpr int kMostMinutes = 600;                             // for an exercise
inline constexpr double kLeastTolerance = 0.02, kMostTolerance = 2;  // mm
inline constexpr std::size_t kMostCorners = 200;                     // of an outline
inline constexpr std::size_t kMostDecayPlaces = 60;                  // beside the first one
inline constexpr std::size_t kMostZones = 20;                        // where nothing may be cut

/// The directions that have a name, out of the tooth, unit; `mesialX` as that of the tooth.
[[nodiscard]] inline std::array<std::pair<std::string_view, Vec3>, 5> sideKeys(double mesialX) {
    return {{{"occlusal", Vec3::UnitZ()},
             {"buccal", Vec3::UnitY()},
             {"lingual", -Vec3::UnitY()},
             {"mesial", mesialX * Vec3::UnitX()},
             {"distal", -mesialX * Vec3::UnitX()}}};
}

/// The nesting orders that the material of a decay's rim may have: from `least` to below `above`. So the rim replaces
/// dentin, but neither pulp nor decay.
struct RimNesting {
    int least, above;
};
[[nodiscard]] inline RimNesting rimNesting(const MaterialRegistry& materials) {
    return {materials[materials.withRole(MaterialRole::Dentin)].nesting,
            materials[materials.withRole(MaterialRole::Pulp)].nesting};
}

/// The mesial direction on the x axis: +1 for a surface from a file.
[[nodiscard]] inline double toothMesialX(const std::variant<ToothRequest, ToothSource>& tooth) {
    const auto* request = std::get_if<ToothRequest>(&tooth);
    return request != nullptr ? mesialX(request->fdi) : 1;
}

}  // namespace tactooth
