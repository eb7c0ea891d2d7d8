// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/io/remark.h"
#include "session/simulation/tooth_source.h"
#include "session/simulation/work_piece.h"
#include "tooth/file/saved_tooth.h"

namespace tactooth {

/// Ending of the files that hold a cut tooth.
inline constexpr std::string_view kToothFileEnding = ".tactooth";

/// The tooth on the bench as a file's bytes.
[[nodiscard]] std::vector<std::byte> toothFileBytes(const WorkPiece& piece, const Provenance& provenance);
/// The same into a file, which appears when it is complete.
[[nodiscard]] Expected<void> saveTooth(const WorkPiece& piece, const Provenance& provenance,
                                       const std::filesystem::path& path);

/// A tooth from a file, ready to be cut further.
struct OpenedTooth {
    std::shared_ptr<WorkPiece> piece;
    Provenance provenance;
    std::vector<Remark> remarks = {};  ///< on the files that were read, and what was mended
};
[[nodiscard]] Expected<OpenedTooth> openTooth(const std::filesystem::path& path);

/// A tooth for the bench: from surfaces, or a saved one if the source's outer surface names such a file. `voxel`:
/// spacing of the cut volume, mm; without it a saved tooth keeps its own, and another takes `usualVoxel`.
[[nodiscard]] Expected<OpenedTooth> loadTooth(const ToothSource& source, std::optional<double> voxel,
                                              double usualVoxel);

/// Whether a file's name says that it holds a saved tooth.
[[nodiscard]] bool isToothFile(const std::filesystem::path& path);

/// Adds when and by which version of the sources a tooth was saved. Such a file is handed on: by whom, where and by
/// which command is nobody else's business.
[[nodiscard]] Provenance savedNow(Provenance before);

}  // namespace tactooth
