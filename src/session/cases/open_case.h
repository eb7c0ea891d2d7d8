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

/// All bodies of a case in the frame of the tooth that is worked on. All of them can be touched and cut.
struct OpenedCase {
    CaseDescription description;
    std::string tooth;  ///< name of the one that is worked on
    std::shared_ptr<const LayeredTooth> teeth;
    Box3 box;                             ///< of the tooth that is worked on, mm
    double mesialX = 1;                   ///< direction of mesial along x
    std::optional<CustomBur> bur;         ///< the first one
    std::vector<ImportNote> importNotes;  ///< on repairs of its surfaces (`examineSolid`)
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

/// Two bodies of a case that overlap.
struct CaseOverlap {
    std::string first, second;
    double deepest;  ///< greatest depth of a vertex of one body in the other, mm
};

/// A body of a case, in the case's frame.
struct CaseBody {
    std::string name;
    TriangleMesh surface;
};

/// The outer surfaces of the teeth, then the bodies around them.
[[nodiscard]] Expected<std::vector<CaseBody>> caseBodies(const CaseStore& store, const CaseDescription& description);

/// Finds overlaps of teeth and bodies around them. There the surface is not that of one body, and the common volume
/// counts as air.
[[nodiscard]] std::vector<CaseOverlap> overlaps(const std::vector<CaseBody>& bodies);

}  // namespace tactooth
