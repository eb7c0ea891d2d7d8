// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"
#include "session/cases/case_description.h"
#include "session/cases/case_store.h"
#include "session/cases/custom_bur.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// All of a case, in the frame of the tooth that is worked on: the others and what is around stand in their places,
/// and all of it is felt and can be cut.
struct OpenedCase {
    CaseDescription description;
    std::string tooth;  ///< name of the one that is worked on
    std::shared_ptr<const LayeredTooth> teeth;
    Box3 box;                             ///< of the tooth that is worked on, mm
    double mesialX = 1;                   ///< direction of mesial along x
    std::optional<CustomBur> bur;         ///< the first one
    std::vector<ImportNote> importNotes;  ///< what was mended in its surfaces (`examineSolid`)
};

/// Reads and checks a case. `tooth`: the one to work on, by its name or FDI number; empty: the first. Its layers keep
/// their names of one tooth; those of the others are named "37 enamel". `materials`: instead of the case's own. Fails
/// with one sentence that names the file.
[[nodiscard]] Expected<OpenedCase> openCase(const CaseStore& store, const std::string& tooth = {},
                                            const MaterialRegistry* materials = nullptr);
[[nodiscard]] Expected<OpenedCase> openCase(const std::filesystem::path& path, const std::string& tooth = {},
                                            const MaterialRegistry* materials = nullptr);

/// Reads the description and the materials alone. `materials`: instead of the case's own.
[[nodiscard]] Expected<CaseDescription> readCaseDescription(const CaseStore& store,
                                                            const MaterialRegistry* materials = nullptr);

/// Two bodies of a case that share room.
struct CaseOverlap {
    std::string first, second;
    double deepest;  ///< mm that a corner of the one lies within the other
};

/// What stands in a case by name, with the surface in the case's frame.
struct CaseBody {
    std::string name;
    TriangleMesh surface;
};

/// The outer surfaces of the teeth, then what is around.
[[nodiscard]] Expected<std::vector<CaseBody>> caseBodies(const CaseStore& store, const CaseDescription& description);

/// Where teeth stand in each other or in what is around: in such places the surface is not that of one body, and what
/// both claim counts as air.
[[nodiscard]] std::vector<CaseOverlap> overlaps(const std::vector<CaseBody>& bodies);

}  // namespace tactooth
