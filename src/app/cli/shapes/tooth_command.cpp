// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/shapes/tooth_command.h"

#include <fmt/core.h>

#include <array>
#include <utility>

#include "app/cli/terminal/mesh_summary.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/files/folder.h"
#include "geometry/io/stl_writer.h"
#include "session/simulation/tooth_cache.h"

namespace tactooth {
namespace {

LesionSite siteOf(const std::string& word) {
    static constexpr std::array<std::pair<const char*, LesionSite>, 5> kSites = {{{"occlusal", LesionSite::Occlusal},
                                                                                  {"mesial", LesionSite::Mesial},
                                                                                  {"distal", LesionSite::Distal},
                                                                                  {"buccal", LesionSite::Buccal},
                                                                                  {"lingual", LesionSite::Lingual}}};
    for (const auto& [name, site] : kSites) {
        if (word == name) return site;
    }
    return LesionSite::Usual;
}

void printSize(const BuiltinTooth& tooth) {
    const Box3 box = boundingBox(tooth.outer);
    print(
        "{} (FDI {}): crown {:.1f} mm, root {:.1f} mm, {:.1f} x {:.1f} mm; +z to the crown, +y buccal, mesial "
        "at {}x\n",
        tooth.name, tooth.fdi, box.max().z(), -box.min().z(), box.sizes().x(), box.sizes().y(),
        mesialX(tooth.fdi) > 0 ? '+' : '-');
}

}  // namespace

int runTooth(const ToothOptions& options) {
    if (!isPermanentTooth(options.fdi)) {
        return reportError({msg::kNoPermanentToothGiven, options.fdi});
    }
    if (options.caries == "occlusal" && isAnteriorTooth(options.fdi)) {
        return reportError({msg::kNoOcclusalSurface, options.fdi});
    }
    FileTransaction files;
    if (const auto made = files.makeFolder(options.out); !made) return reportError(made.error());
    for (const char* name : {"outer.stl", "enamel.stl", "dentin.stl", "pulp.stl", "caries.stl"}) {
        if (const auto opened = files.open(options.out / name); !opened) return reportError(opened.error());
    }
    ToothRequest request{options.fdi, options.triangles, options.seed, {}};
    if (!options.caries.empty()) {
        request.lesion = Lesion{siteOf(options.caries), options.cariesWidth, options.cariesDepth};
    }
    const BuiltinTooth tooth = options.noCache ? makeTooth(request) : ToothCache(defaultCacheFolder()).make(request);
    printSize(tooth);
    std::string lines;
    for (const auto& [name, mesh] : {std::pair("outer.stl", &tooth.outer), std::pair("enamel.stl", &tooth.enamel),
                                     std::pair("dentin.stl", &tooth.dentin), std::pair("pulp.stl", &tooth.pulp),
                                     std::pair("caries.stl", &tooth.caries)}) {
        if (mesh->empty()) continue;
        const std::filesystem::path file = options.out / name;
        if (const auto done = writeStl(*mesh, file); !done) return reportError(done.error());
        lines += fmt::format("{}: {}\n", displayName(file), meshSummary(reportOn(*mesh)));
    }
    if (const auto done = files.commit(); !done) return reportError(done.error());
    print("{}", lines);
    return kExitOk;
}

}  // namespace tactooth
