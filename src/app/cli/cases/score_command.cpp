// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/score_command.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/messages.h"
#include "assessment/cavity_metrics.h"
#include "assessment/ideal_shape.h"
#include "assessment/metric_table.h"
#include "geometry/files/file_bytes.h"
#include "session/simulation/tooth_file.h"

namespace tactooth {
namespace {

constexpr std::size_t kQuantityWidth = 18;  // minimum number of letters in the table's first column

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

std::string asJson(const ScoreOptions& options, const CavityProgress& cavity, const CutModel& piece) {
    const ToothLoss& loss = piece.loss();
    const MaterialRegistry& materials = piece.tooth().materials();
    nlohmann::ordered_json json = {{"tooth", displayName(options.tooth)}, {"target", displayName(options.target)}};
    for (const Metric& metric : metricTable()) json[std::string(metric.key)] = metric.compute(cavity);
    for (const MaterialId id : materials.ids())
        json["removed_mm3"][materials.nameOf(id)] = loss.removed[static_cast<std::size_t>(id)];
    json["removed_beside_mm3"] = loss.beside;
    return json.dump(1) + '\n';
}

/// One row of the text table.
struct ScoreLine {
    std::string quantity;
    double value;
    int decimals;
    std::string_view unit;
};

std::string asTable(const ScoreOptions& options, const CavityProgress& cavity, const CutModel& piece) {
    const ToothLoss& loss = piece.loss();
    const MaterialRegistry& materials = piece.tooth().materials();
    std::vector<ScoreLine> lines;
    for (const Metric& metric : metricTable()) {
        lines.push_back(
            {std::string(metric.quantity), metric.shown(cavity), metric.isFraction() ? 0 : 2, metric.shownUnit()});
    }
    for (const MaterialId id : materials.ids()) {
        const double removed = loss.removed[static_cast<std::size_t>(id)];
        if (removed > 0) lines.push_back({materials.nameOf(id) + " removed", removed, 2, "mm^3"});
    }
    if (loss.beside > 0) lines.push_back({"of it beside", loss.beside, 2, "mm^3"});
    std::size_t width = kQuantityWidth;
    for (const ScoreLine& line : lines) width = std::max(width, line.quantity.size());
    std::string text = fmt::format("{} against {}\n", displayName(options.tooth), displayName(options.target));
    for (const ScoreLine& line : lines) {
        text += fmt::format("  {:<{}} {:8.{}f} {}\n", line.quantity, width, line.value, line.decimals, line.unit);
    }
    return text;
}

}  // namespace

int runScore(const ScoreOptions& options) {
    if (!isToothFile(options.tooth)) {
        return reportError({msg::kNoSavedToothGiven, displayName(options.tooth)});
    }
    const Expected<OpenedTooth> opened = openTooth(options.tooth);
    if (!opened) return reportError(opened.error());
    printImportNotes(opened->importNotes);
    const Expected<CavityProgress> cavity = progressOf(*opened->piece, options.target);
    if (!cavity) return reportError(cavity.error());
    const CutModel& piece = *opened->piece;
    writeTo(stdout, options.json ? asJson(options, *cavity, piece) : asTable(options, *cavity, piece));
    return kExitOk;
}

}  // namespace tactooth
