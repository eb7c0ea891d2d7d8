// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/io/import_note.h"
#include "session/simulation/cut_model.h"
#include "session/simulation/tooth_source.h"
#include "tooth/file/saved_tooth.h"

namespace tactooth {

/// Ending of the files that hold a cut tooth.
inline constexpr std::string_view kToothFileEnding = ".tactooth";

/// The bytes of the file of a tooth. `work`: see workText; empty: none.
[[nodiscard]] std::vector<std::byte> toothFileBytes(const CutModel& piece, const Provenance& provenance,
                                                    const std::string& work = {});
/// Writes the file, which appears when it is complete.
[[nodiscard]] Expected<void> saveTooth(const CutModel& piece, const Provenance& provenance,
                                       const std::filesystem::path& path);

/// A tooth from a file; it can be cut further.
struct OpenedTooth {
    std::shared_ptr<CutModel> piece;
    Provenance provenance;
    std::vector<ImportNote> importNotes = {};  ///< on the files and on repairs
    std::string work = {};                     ///< see workText; empty: the file has none
};
/// A tooth from the bytes of its file; `name` stands for them in messages. `materials`: see parseSavedTooth.
[[nodiscard]] Expected<OpenedTooth> parseTooth(std::span<const std::byte> bytes, const std::string& name,
                                               const MaterialRegistry& materials);
/// `materials`: null for the built-in ones. A material of the file that is not among them is taken as the surroundings,
/// and an import note says so.
[[nodiscard]] Expected<OpenedTooth> openTooth(const std::filesystem::path& path,
                                              const MaterialRegistry* materials = nullptr);

/// Loads a tooth from surfaces, or a saved tooth if the source's outer surface names such a file. `voxel`: spacing of
/// the cut volume, mm; without it a saved tooth keeps its own, and another tooth takes `defaultVoxel`.
[[nodiscard]] Expected<OpenedTooth> loadTooth(const ToothSource& source, std::optional<double> voxel,
                                              double defaultVoxel);

/// Whether the name of a file is that of a saved tooth.
[[nodiscard]] bool isToothFile(const std::filesystem::path& path);

/// Adds the date and the version of the sources. The file may be handed on, so user, folder and command stay out.
[[nodiscard]] Provenance savedNow(Provenance before);

}  // namespace tactooth
