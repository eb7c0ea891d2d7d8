// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/tooth_file.h"

#include <cmath>

#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/messages.h"
#include "session/io/messages.h"
#include "session/io/run_metadata.h"

namespace tactooth {

std::vector<std::byte> toothFileBytes(const CutModel& piece, const Provenance& provenance, const std::string& work) {
    return savedToothBytes(piece.volume(), piece.removed(), provenance, work);
}

Expected<void> saveTooth(const CutModel& piece, const Provenance& provenance, const std::filesystem::path& path) {
    return writeFile(path, toothFileBytes(piece, provenance));
}

namespace {

std::vector<ImportNote> notesOn(const std::vector<std::string>& unknownMaterials) {
    std::vector<ImportNote> notes;
    for (const std::string& name : unknownMaterials) {
        notes.push_back({ImportNoteTopic::Layers, {msg::kNoteUnknownMaterial, name}});
    }
    return notes;
}

}  // namespace

Expected<OpenedTooth> openTooth(const std::filesystem::path& path, const MaterialRegistry* materials) {
    const auto file = readFile(path);
    if (!file) return Unexpected{file.error()};
    return parseTooth(file->bytes(), displayName(path), materials != nullptr ? *materials : builtinMaterials());
}

Expected<OpenedTooth> parseTooth(std::span<const std::byte> bytes, const std::string& name,
                                 const MaterialRegistry& materials) {
    auto saved = parseSavedTooth(bytes, name, materials);
    if (!saved) return Unexpected{saved.error()};
    auto tooth = LayeredTooth::make(std::move(saved->outer), std::move(saved->layers), saved->body, saved->toothContext,
                                    *saved->materials);
    if (!tooth) return unexpected(msg::kNamed, name, tooth.error());
    auto piece = std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), saved->voxel);
    piece->adopt(saved->cuts, saved->removed);
    return OpenedTooth{std::move(piece), std::move(saved->provenance), notesOn(saved->unknownMaterials),
                       std::move(saved->work)};
}

Expected<OpenedTooth> loadTooth(const ToothSource& source, std::optional<double> voxel, double defaultVoxel) {
    if (isToothFile(source.outer)) {
        const std::string name = displayName(source.outer);
        if (!source.layers.empty()) return unexpected(msg::kSavedToothHasLayers, name);
        auto opened = openTooth(source.outer, source.materials);
        if (opened && voxel && *voxel != opened->piece->volume().lattice().spacing()) {
            return unexpected(msg::kSavedToothHasSpacing, name,
                              std::lround(1e3 * opened->piece->volume().lattice().spacing()));
        }
        return opened;
    }
    OpenedTooth opened;
    auto tooth = loadLayeredTooth(source, &opened.importNotes);
    if (!tooth) return Unexpected{tooth.error()};
    opened.provenance.emplace_back("tooth", displayFileName(source.outer));
    for (const ToothSource::Layer& layer : source.layers) {
        opened.provenance.emplace_back("layer " + layer.material, displayFileName(layer.file));
    }
    opened.piece = std::make_shared<CutModel>(std::move(*tooth), voxel.value_or(defaultVoxel));
    return opened;
}

bool isToothFile(const std::filesystem::path& path) { return path.extension() == kToothFileEnding; }

Provenance savedNow(Provenance before) {
    const RunMetadata facts = currentRunMetadata();
    // Files of earlier versions hold commands and whole paths.
    std::erase_if(before, [](const auto& note) { return note.first == "command"; });
    for (auto& [what, value] : before) {
        const bool isFile = what == "tooth" || what == "case" || what.starts_with("layer ");
        if (isFile && value.find('/') != std::string::npos) value = displayFileName(value);
    }
    before.emplace_back("saved", facts.date);
    before.emplace_back("sources", facts.commit);
    return before;
}

}  // namespace tactooth
