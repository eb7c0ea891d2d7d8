// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "collision/neighbours/tool_shape.h"
#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"
#include "session/cases/custom_bur.h"

namespace tactooth {

// A bur as a user names it: a number that findBur knows, or a file. The number counts if there is a file of that name,
// too; "./57" is the file. Both fail with one sentence. `importNotes`: on a file and its repairs, if given.

/// The bur with all its properties. A file is read as by readCustomBur.
[[nodiscard]] Expected<CustomBur> findOrReadBur(const std::filesystem::path& numberOrFile,
                                                std::vector<ImportNote>* importNotes = nullptr);
/// The shape of the bur, or of any other tool. A file is read as by loadTool.
[[nodiscard]] Expected<std::shared_ptr<const ToolShape>> findOrLoadTool(const std::filesystem::path& numberOrFile,
                                                                        std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
