// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/tooth_file.h"

#include <cmath>

#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "session/io/run_facts.h"

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
    auto tooth = LayeredTooth::make(std::move(saved->outer), std::move(saved->layers), saved->body, saved->standing);
    if (!tooth) return unexpected(shownName(path) + ": " + tooth.error().message + ".");
    auto piece = std::make_shared<WorkPiece>(std::make_shared<const LayeredTooth>(std::move(*tooth)), saved->voxel);
    piece->adopt(saved->cuts, saved->removed);
    return OpenedTooth{std::move(piece), std::move(saved->provenance)};
}

Expected<OpenedTooth> loadTooth(const ToothSource& source, std::optional<double> voxel, double usualVoxel) {
    if (isToothFile(source.outer)) {
        const std::string name = shownName(source.outer);
        if (!source.layers.empty()) return unexpected(name + ": a saved tooth has its own layers; give no others.");
        auto opened = openTooth(source.outer);
        if (opened && voxel && *voxel != opened->piece->volume().lattice().spacing()) {
            return unexpected(name + ": a saved tooth keeps the spacing that it was cut with, " +
                              std::to_string(std::lround(1e3 * opened->piece->volume().lattice().spacing())) +
                              " um; give no other.");
        }
        return opened;
    }
    OpenedTooth opened;
    auto tooth = loadLayeredTooth(source, &opened.remarks);
    if (!tooth) return Unexpected{tooth.error()};
    opened.provenance.emplace_back("tooth", shownNameAlone(source.outer));
    for (const ToothSource::Layer& layer : source.layers) {
        opened.provenance.emplace_back("layer " + layer.material, shownNameAlone(layer.file));
    }
    opened.piece = std::make_shared<WorkPiece>(std::move(*tooth), voxel.value_or(usualVoxel));
    return opened;
}

bool isToothFile(const std::filesystem::path& path) { return path.extension() == kToothFileEnding; }

Provenance savedNow(Provenance before) {
    const RunFacts facts = currentRunFacts();
    // Files of earlier versions hold commands and whole paths.
    std::erase_if(before, [](const auto& note) { return note.first == "command"; });
    for (auto& [what, value] : before) {
        const bool isFile = what == "tooth" || what == "case" || what.starts_with("layer ");
        if (isFile && value.find('/') != std::string::npos) value = shownNameAlone(value);
    }
    before.emplace_back("saved", facts.date);
    before.emplace_back("sources", facts.commit);
    return before;
}

}  // namespace tactooth
