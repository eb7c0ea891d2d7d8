// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/common/scene_builder.h"
#include "app/gui/text/messages.h"
#include "assessment/exercise.h"
#include "instruments/builtin_tooth.h"
#include "patient/scan_import.h"
#include "session/simulation/simulator.h"
#include "session/simulation/tooth_file.h"
#include "session/simulation/tooth_source.h"

namespace tactooth {

/// A bur that is ready to work.
struct SessionBur {
    std::string name;  ///< for people
    Instrument instrument;
    std::shared_ptr<const TriangleMesh> shown;
    std::shared_ptr<const TriangleMesh> blurred;  ///< as it is seen turning fast
    BurMaterial material = BurMaterial::Carbide;
    std::filesystem::path file;  ///< that it came from; empty for a bur of the catalogue
};

/// A tooth that is ready to be worked on.
struct SessionTooth {
    std::string name;  ///< for people
    std::shared_ptr<CutModel> piece;
    double mesialX = 1;  ///< direction of mesial along x; a file's frame is taken to have it at +x
    Provenance provenance;
    Box3 workBox = {};  ///< of the tooth that is worked on among others, mm; empty: all of the piece
    std::optional<MaterialTable> materials = {};    ///< that a case brings
    std::vector<std::string> teethOfCase = {};      ///< names; empty: it is no case
    std::optional<SessionBur> bur = {};             ///< that a case brings
    std::vector<ShownBody> around = {};             ///< the rest of the mouth, which is felt and drawn
    std::shared_ptr<const Exercise> exercise = {};  ///< that it was brought for
    std::vector<ImportNote> importNotes = {};       ///< what was mended in the surfaces that were read

    [[nodiscard]] Box3 box() const { return workBox.isEmpty() ? piece->tooth().outer()->tree().box() : workBox; }
};

/// What stands around: the same for every tooth. The mirror comes by replaceMirror.
struct SessionInstruments {
    std::shared_ptr<const TriangleMesh> turbine;
    std::shared_ptr<const TriangleMesh> mirror;
    MirrorDisc disc;
    std::shared_ptr<const TriangleMesh> suction;
};

/// The built-in teeth as a list shows them.
struct BuiltinToothEntry {
    BuiltinToothKind kind;
    std::string_view name;
};
inline constexpr std::array<BuiltinToothEntry, 3> kBuiltinTeeth = {{
    {BuiltinToothKind::LowerFirstMolar, msg::kLowerFirstMolar.english},
    {BuiltinToothKind::UpperCentralIncisor, msg::kUpperCentralIncisor.english},
    {BuiltinToothKind::UpperCanine, msg::kUpperCanine.english},
}};

/// The mouth that a tooth stands in: average teeth, open as for work.
struct MouthChoice {
    int fdi = 46;  ///< of the tooth that is worked on
    bool cached = true;
};

// All of these take a second or so: they belong into an Errand. Failing gives a sentence for the user.
[[nodiscard]] Expected<SessionTooth> makeSessionTooth(const BuiltinToothEntry& entry);
[[nodiscard]] Expected<SessionTooth> makeSessionTooth(const MouthChoice& mouth);
/// The tooth brings the bur of the exercise.
[[nodiscard]] Expected<SessionTooth> makeSessionTooth(const std::shared_ptr<const Exercise>& exercise);
[[nodiscard]] Expected<SessionTooth> loadSessionTooth(const ToothSource& source, const std::string& workOn = {});
[[nodiscard]] Expected<SessionBur> makeSessionBur(const BurSpec& spec);
/// `scan` with layers, as scan_import.h finishes it.
[[nodiscard]] Expected<SessionTooth> makeSessionTooth(const ExaminedScan& scan);
[[nodiscard]] Expected<SessionBur> loadSessionBur(const std::filesystem::path& path);
[[nodiscard]] SessionInstruments makeSessionInstruments();
/// A mirror with a head of this diameter (mm) in the place of the old one; a matter of a millisecond.
void replaceMirror(SessionInstruments& instruments, double diameter);

}  // namespace tactooth
