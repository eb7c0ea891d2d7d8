// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/loaded_tooth.h"

#include "geometry/files/file_bytes.h"
#include "session/cases/open_case.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

ToothPlacement placeOf(const LayeredTooth& tooth, std::string name) {
    return {std::move(name), tooth.ownBox(), tooth.toothContext().mesialX};
}

Expected<LoadedTooth> loadCase(const ToothSource& source, const std::string& workOn) {
    if (!source.layers.empty()) {
        return unexpected(msg::kCaseHasLayers, displayName(source.outer));
    }
    auto opened = openCase(source.outer, workOn, source.materials);
    if (!opened) return Unexpected{opened.error()};
    const CaseDescription& description = opened->description;
    LoadedTooth placed{opened->teeth, placeOf(*opened->teeth, description.title)};
    ToothPlacement& place = placed.place;
    for (const CaseTooth& tooth : description.teeth) place.teethOfCase.push_back(tooth.name);
    if (place.teethOfCase.size() > 1) place.name += ", " + opened->tooth;
    place.bur = std::move(opened->bur);
    placed.importNotes = std::move(opened->importNotes);
    placed.provenance = {
        {"case", displayFileName(source.outer)}, {"tooth", opened->tooth}, {"licence", description.licence}};
    for (const std::string& line : description.provenance) placed.provenance.emplace_back("case from", line);
    return placed;
}

/// Fails if a tooth is chosen of something that is no case.
Expected<void> refuseChoice(const ToothSource& source, const std::string& workOn) {
    if (workOn.empty()) return {};
    return unexpected(msg::kNoChoiceOfTooth, displayName(source.outer));
}

}  // namespace

Expected<LoadedTooth> loadToothOrCase(const ToothSource& source, const std::string& workOn) {
    if (isCase(source.outer)) return loadCase(source, workOn);
    if (auto single = refuseChoice(source, workOn); !single) return Unexpected{single.error()};
    std::vector<ImportNote> importNotes;
    auto tooth = loadLayeredTooth(source, &importNotes);
    if (!tooth) return Unexpected{tooth.error()};
    return LoadedTooth{*tooth, placeOf(**tooth, displayFileName(source.outer)), {}, std::move(importNotes)};
}

Expected<LoadedModel> loadModelOrCase(const ToothSource& source, const std::string& workOn, std::optional<double> voxel,
                                      double defaultVoxel) {
    if (isCase(source.outer)) {
        auto placed = loadCase(source, workOn);
        if (!placed) return Unexpected{placed.error()};
        auto piece = std::make_shared<CutModel>(std::move(placed->tooth), voxel.value_or(defaultVoxel));
        return LoadedModel{std::move(piece),
                           std::move(placed->place),
                           std::move(placed->provenance),
                           std::move(placed->importNotes),
                           {}};
    }
    if (auto single = refuseChoice(source, workOn); !single) return Unexpected{single.error()};
    auto opened = loadTooth(source, voxel, defaultVoxel);
    if (!opened) return Unexpected{opened.error()};
    ToothPlacement place = placeOf(opened->piece->tooth(), displayFileName(source.outer));
    return LoadedModel{std::move(opened->piece), std::move(place), std::move(opened->provenance),
                       std::move(opened->importNotes), std::move(opened->work)};
}

}  // namespace tactooth
