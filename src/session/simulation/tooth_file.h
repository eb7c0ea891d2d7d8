// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/io/import_note.h"
#include "session/simulation/cut_model.h"
#include "session/simulation/tooth_source.h"
#include "tooth/file/saved_tooth.h"

namespace tactooth {

/// Ending of the files that hold a cut tooth.
inline constexpr std::string_view kToothFileEnding = ".tactooth";

/// The tooth on the bench as a file's bytes.
[[nodiscard]] std::vector<std::byte> toothFileBytes(const CutModel& piece, const Provenance& provenance);
/// The same into a file, which appears when it is complete.
[[nodiscard]] Expected<void> saveTooth(const CutModel& piece, const Provenance& provenance,
                                       const std::filesystem::path& path);

/// A tooth from a file, ready to be cut further.
struct OpenedTooth {
    std::shared_ptr<CutModel> piece;
    Provenance provenance;
    std::vector<ImportNote> importNotes = {};  ///< on the files that were read, and what was mended
};
/// `materials`: null for the built-in ones. A material of the file that is not among them is taken as the surroundings,
/// and an import note says so.
[[nodiscard]] Expected<OpenedTooth> openTooth(const std::filesystem::path& path,
                                              const MaterialRegistry* materials = nullptr);

/// A tooth for the bench: from surfaces, or a saved one if the source's outer surface names such a file. `voxel`:
/// spacing of the cut volume, mm; without it a saved tooth keeps its own, and another takes `defaultVoxel`.
[[nodiscard]] Expected<OpenedTooth> loadTooth(const ToothSource& source, std::optional<double> voxel,
                                              double defaultVoxel);

/// Whether a file's name says that it holds a saved tooth.
[[nodiscard]] bool isToothFile(const std::filesystem::path& path);

/// Adds when and by which version of the sources a tooth was saved. Such a file is handed on: by whom, where and by
/// which command is nobody else's business.
[[nodiscard]] Provenance savedNow(Provenance before);

}  // namespace tactooth
