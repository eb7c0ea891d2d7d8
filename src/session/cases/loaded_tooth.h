// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/io/import_note.h"
#include "session/cases/custom_bur.h"
#include "session/simulation/tooth_file.h"

namespace tactooth {

/// The placement of a loaded tooth, and other parts of its case.
struct ToothPlacement {
    std::string name;                           ///< for people
    Box3 box;                                   ///< of the tooth that is worked on, mm
    double mesialX = 1;                         ///< direction of mesial along x; 1 for a surface from a file
    std::optional<CustomBur> bur = {};          ///< of the case
    std::vector<std::string> teethOfCase = {};  ///< names; empty: no case
};

struct LoadedTooth {
    std::shared_ptr<const LayeredTooth>
        tooth;  ///< of a case: all its bodies, in the frame of the tooth that is worked on
    ToothPlacement place;
    Provenance provenance = {};
    std::vector<ImportNote> importNotes = {};  ///< on the files that were read, and on repairs
};

/// A tooth from surfaces, or from a case if the source's outer surface names one (docs/cases.md); `workOn` is then the
/// tooth to work on, by name or FDI number, or the first if empty. Fails with one sentence.
[[nodiscard]] Expected<LoadedTooth> loadToothOrCase(const ToothSource& source, const std::string& workOn);

/// A tooth that can be cut.
struct LoadedModel {
    std::shared_ptr<CutModel> piece;
    ToothPlacement place;
    Provenance provenance = {};
    std::vector<ImportNote> importNotes = {};  ///< on the files that were read, and on repairs
    std::string work = {};                     ///< of a saved tooth: see workText
};

/// The same as a model to cut; also from a saved tooth. `voxel` and `defaultVoxel` as for loadTooth.
[[nodiscard]] Expected<LoadedModel> loadModelOrCase(const ToothSource& source, const std::string& workOn,
                                                    std::optional<double> voxel, double defaultVoxel);

}  // namespace tactooth
