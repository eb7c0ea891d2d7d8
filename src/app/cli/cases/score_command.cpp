// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/score_command.h"

#include <fmt/core.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "assessment/cavity_metrics.h"
#include "assessment/ideal_shape.h"
#include "geometry/files/file_bytes.h"
#include "session/simulation/tooth_file.h"

namespace tactooth {
namespace {

constexpr double kPercent = 100;

Expected<CavityProgress> progressOf(const CutModel& piece, const std::filesystem::path& target) {
    std::vector<ImportNote> importNotes;
    Expected<TriangleMesh> ideal = loadIdealShape(target, &importNotes);
    if (!ideal) return Unexpected{ideal.error()};
    printImportNotes(importNotes);
    CavityMetrics metrics(std::make_shared<const SurfacePart>(std::move(*ideal)), *piece.tooth().ownOuter());
    if (metrics.empty()) {
        return unexpected(msg::kTargetLeavesNothing, displayName(target));
    }
    return metrics.of(*piece.surface(), total(piece.removed()));
}

std::string asJson(const ScoreOptions& options, const CavityProgress& cavity, const ToothLoss& loss) {
    nlohmann::ordered_json json = {{"tooth", displayName(options.tooth)},
                                   {"target", displayName(options.target)},
                                   {"ideal_mm3", cavity.planned},
                                   {"cleared_mm3", cavity.cleared},
                                   {"cleared_share", cavity.clearedFraction()},
                                   {"beyond_mm3", cavity.beyond},
                                   {"deepest_beyond_mm", cavity.maxOverPreparation},
                                   {"likeness", cavity.dice()}};
    for (std::size_t id = 0; id < kMaterialCount; ++id)
        json["removed_mm3"][std::string(materialName(static_cast<MaterialId>(id)))] = loss.removed[id];
    json["removed_beside_mm3"] = loss.beside;
    return json.dump(1) + '\n';
}

std::string asTable(const ScoreOptions& options, const CavityProgress& cavity, const ToothLoss& loss) {
    std::string text = fmt::format("{} against {}\n", displayName(options.tooth), displayName(options.target));
    text += fmt::format("  ideal cavity   {:8.2f} mm3\n", cavity.planned);
    text +=
        fmt::format("  of it cut      {:8.2f} mm3, {:.0f} %\n", cavity.cleared, kPercent * cavity.clearedFraction());
    text += fmt::format("  cut beyond it  {:8.2f} mm3, {:.2f} mm deep at worst\n", cavity.beyond,
                        cavity.maxOverPreparation);
    text += fmt::format("  likeness       {:8.0f} %\n", kPercent * cavity.dice());
    for (std::size_t id = 0; id < kMaterialCount; ++id) {
        if (loss.removed[id] <= 0) continue;
        text +=
            fmt::format("  {:<14} {:8.2f} mm3 removed\n", materialName(static_cast<MaterialId>(id)), loss.removed[id]);
    }
    if (loss.beside > 0) text += fmt::format("  of it          {:8.2f} mm3 beside the tooth\n", loss.beside);
    return text;
}

}  // namespace

int runScore(const ScoreOptions& options) {
    if (!isToothFile(options.tooth)) {
        return reportError({msg::kNoSavedToothGiven, displayName(options.tooth)});
    }
    const Expected<OpenedTooth> opened = openTooth(options.tooth);
    if (!opened) return reportError(opened.error());
    const Expected<CavityProgress> cavity = progressOf(*opened->piece, options.target);
    if (!cavity) return reportError(cavity.error());
    const ToothLoss& loss = opened->piece->loss();
    writeTo(stdout, options.json ? asJson(options, *cavity, loss) : asTable(options, *cavity, loss));
    return kExitOk;
}

}  // namespace tactooth
