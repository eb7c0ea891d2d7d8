// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/placed_tooth.h"

#include "geometry/files/file_bytes.h"
#include "session/cases/open_case.h"

namespace tactooth {
namespace {

ToothPlace placeOf(const LayeredTooth& tooth, std::string name) {
    return {std::move(name), tooth.ownBox(), tooth.standing().mesialX};
}

Expected<PlacedTooth> loadCase(const ToothSource& source, const std::string& workOn) {
    if (!source.layers.empty()) {
        return unexpected(shownName(source.outer) + ": a case has its own layers; give no others.");
    }
    auto opened = openCase(source.outer, workOn);
    if (!opened) return Unexpected{opened.error()};
    const CaseDescription& description = opened->description;
    PlacedTooth placed{opened->teeth, placeOf(*opened->teeth, description.title)};
    ToothPlace& place = placed.place;
    for (const CaseTooth& tooth : description.teeth) place.teethOfCase.push_back(tooth.name);
    if (place.teethOfCase.size() > 1) place.name += ", " + opened->tooth;
    place.materials = std::move(opened->materials);
    place.bur = std::move(opened->bur);
    placed.remarks = std::move(opened->remarks);
    placed.provenance = {
        {"case", shownNameAlone(source.outer)}, {"tooth", opened->tooth}, {"licence", description.licence}};
    for (const std::string& line : description.provenance) placed.provenance.emplace_back("case from", line);
    return placed;
}

/// Only a case has teeth to choose from.
Expected<void> refuseChoice(const ToothSource& source, const std::string& workOn) {
    if (workOn.empty()) return {};
    return unexpected(shownName(source.outer) + ": this is one tooth; a tooth can be chosen in a case only.");
}

}  // namespace

Expected<PlacedTooth> loadPlacedTooth(const ToothSource& source, const std::string& workOn) {
    if (isCase(source.outer)) return loadCase(source, workOn);
    if (auto single = refuseChoice(source, workOn); !single) return Unexpected{single.error()};
    std::vector<Remark> remarks;
    auto tooth = loadLayeredTooth(source, &remarks);
    if (!tooth) return Unexpected{tooth.error()};
    return PlacedTooth{*tooth, placeOf(**tooth, shownNameAlone(source.outer)), {}, std::move(remarks)};
}

Expected<PlacedWork> loadPlacedWork(const ToothSource& source, const std::string& workOn, std::optional<double> voxel,
                                    double usualVoxel) {
    if (isCase(source.outer)) {
        auto placed = loadCase(source, workOn);
        if (!placed) return Unexpected{placed.error()};
        auto piece = std::make_shared<WorkPiece>(std::move(placed->tooth), voxel.value_or(usualVoxel));
        return PlacedWork{std::move(piece), std::move(placed->place), std::move(placed->provenance),
                          std::move(placed->remarks)};
    }
    if (auto single = refuseChoice(source, workOn); !single) return Unexpected{single.error()};
    auto opened = loadTooth(source, voxel, usualVoxel);
    if (!opened) return Unexpected{opened.error()};
    ToothPlace place = placeOf(opened->piece->tooth(), shownNameAlone(source.outer));
    return PlacedWork{std::move(opened->piece), std::move(place), std::move(opened->provenance),
                      std::move(opened->remarks)};
}

}  // namespace tactooth
