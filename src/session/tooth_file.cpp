// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/tooth_file.h"

#include "geometry/atomic_file.h"
#include "geometry/file_bytes.h"
#include "session/experiments/run_facts.h"

namespace tactooth {

std::vector<std::byte> toothFileBytes(const WorkPiece& piece, const Provenance& provenance) {
    return savedToothBytes(piece.volume(), piece.removed(), provenance);
}

Expected<void> saveTooth(const WorkPiece& piece, const Provenance& provenance, const std::filesystem::path& path) {
    return writeFile(path, toothFileBytes(piece, provenance));
}

Expected<OpenedTooth> openTooth(const std::filesystem::path& path) {
    const auto file = readFile(path);
    if (!file) return Unexpected{file.error()};
    auto saved = parseSavedTooth(file->bytes(), shownName(path));
    if (!saved) return Unexpected{saved.error()};
    auto tooth = LayeredTooth::make(std::move(saved->outer), std::move(saved->layers), saved->body);
    if (!tooth) return unexpected(shownName(path) + ": " + tooth.error().message);
    auto piece = std::make_shared<WorkPiece>(std::make_shared<const LayeredTooth>(std::move(*tooth)), saved->voxel);
    piece->adopt(saved->cuts, saved->removed);
    return OpenedTooth{std::move(piece), std::move(saved->provenance)};
}

bool isToothFile(const std::filesystem::path& path) { return path.extension() == kToothFileEnding; }

Provenance savedNow(Provenance before) {
    const RunFacts facts = currentRunFacts();
    before.emplace_back("saved", facts.date);
    before.emplace_back("command", facts.command);
    before.emplace_back("sources", facts.commit);
    return before;
}

}  // namespace tactooth
