// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <any>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/import_note.h"
#include "instruments/builtin_tooth.h"
#include "instruments/messages.h"
#include "patient/scan_import.h"
#include "session/hands/chair_view.h"
#include "session/model/session_bur.h"
#include "session/simulation/session_work.h"
#include "session/simulation/tooth_file.h"
#include "session/simulation/tooth_in_mouth.h"
#include "session/simulation/tooth_source.h"

namespace tactooth {

/// A tooth that is ready to be worked on.
struct SessionTooth {
    std::string name;  ///< for people
    std::shared_ptr<CutModel> piece;
    double mesialX = 1;  ///< direction of mesial along x; a file's frame is taken to have it at +x
    Provenance provenance;
    Box3 workBox = {};  ///< of the tooth that is worked on among others, mm; empty: all of the piece
    std::vector<std::string> teethOfCase = {};     ///< names; empty: the tooth is not from a case
    std::optional<SessionBur> bur = {};            ///< that goes with the tooth: of its case or its exercise
    std::vector<ToothInMouth::Body> around = {};   ///< the rest of the mouth, which is touched and drawn
    std::vector<SoftTissueBody> softTissues = {};  ///< drawn, and not touched
    std::any purpose = {};                         ///< what a layer above made the tooth for; the session keeps it
    std::vector<ImportNote> importNotes = {};      ///< what was repaired in the surfaces that were read
    int mouthTooth = 0;     ///< FDI number, if it stands in the whole built-in mouth; 0: it does not
    SessionWork work = {};  ///< what somebody was doing with it before
    /// What was gone when it was saved last; none: as it is now, nothing is unsaved.
    std::optional<MaterialVolumes> savedAt = {};
    bool wasUnsaved = false;  ///< it came with cuts that no file of the user holds
    int fdi = 0;  ///< FDI number of a built-in tooth that stands alone; 0: not known, or in a mouth (mouthTooth)

    [[nodiscard]] Box3 box() const { return workBox.isEmpty() ? piece->tooth().outer()->tree().box() : workBox; }
};

/// FDI number of a tooth: by the mouth, as it was made, or by its name; 0: unknown.
[[nodiscard]] int fdiOfTooth(const SessionTooth& tooth);
/// How a dentist sees the tooth from the place at the chair from which it is worked on. A tooth whose number is not
/// known is seen from buccal and above, without the mirror.
[[nodiscard]] ChairView chairViewOf(const SessionTooth& tooth);

/// The built-in teeth as a list shows them.
struct BuiltinToothEntry {
    BuiltinToothKind kind;
    std::string_view name;  ///< English
};
inline constexpr std::array<BuiltinToothEntry, 3> kBuiltinTeeth = {{
    {BuiltinToothKind::LowerFirstMolar, msg::kLowerFirstMolar.english},
    {BuiltinToothKind::UpperCentralIncisor, msg::kUpperCentralIncisor.english},
    {BuiltinToothKind::UpperCanine, msg::kUpperCanine.english},
}};

/// A tooth in a whole mouth of average teeth, open as for work.
struct MouthChoice {
    int fdi = 46;                             ///< number of the tooth that is worked on
    bool cached = true;                       ///< teeth and gums may come from the user's cache
    std::optional<Lesion> lesion = Lesion{};  ///< none: the tooth is sound
    std::optional<Filling> filling = {};      ///< of the tooth that is worked on
};

/// Is called with the share of the work that is done, 0..1, from several threads.
using ShareDone = std::function<void(double)>;

// These take up to a few seconds: run them in a Task. They fail with one sentence for the user.
[[nodiscard]] Expected<SessionTooth> makeSessionTooth(const BuiltinToothEntry& entry, const ShareDone& progress = {});
[[nodiscard]] Expected<SessionTooth> makeSessionTooth(const MouthChoice& mouth, const ShareDone& progress = {});
/// `suffix`: added to the built-in tooth's name in the provenance.
[[nodiscard]] Expected<SessionTooth> makeSessionTooth(const ToothRequest& request, const std::string& name,
                                                      const std::string& suffix, const ShareDone& progress = {});
/// `scan`: with layers, as finishScan makes it.
[[nodiscard]] Expected<SessionTooth> makeSessionTooth(const ExaminedScan& scan);
/// `workOn`: name of the tooth of a case; empty: its first. What was being done with a saved tooth is in its `work`.
[[nodiscard]] Expected<SessionTooth> loadSessionTooth(const ToothSource& source, const std::string& workOn = {},
                                                      const ShareDone& progress = {});

/// Puts a tooth back into the whole mouth that it was cut in: takes over its neighbours and gums from there.
[[nodiscard]] Expected<void> putIntoMouth(SessionTooth& tooth, int fdi, const ShareDone& progress = {});

}  // namespace tactooth
