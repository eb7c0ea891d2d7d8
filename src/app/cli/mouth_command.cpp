// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/mouth_command.h"

#include <fmt/core.h>

#include <utility>

#include "app/cli/exit_code.h"
#include "app/cli/mesh_summary.h"
#include "geometry/file_bytes.h"
#include "geometry/folder.h"
#include "geometry/stl_writer.h"
#include "session/tooth_cache.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

Expected<void> writeTooth(const BuiltinTooth& tooth, const Pose& pose, const fs::path& folder) {
    if (auto done = makeFolder(folder); !done) return done;
    for (const auto& [name, mesh] : {std::pair("outer.stl", &tooth.outer), std::pair("enamel.stl", &tooth.enamel),
                                     std::pair("dentin.stl", &tooth.dentin), std::pair("pulp.stl", &tooth.pulp)}) {
        if (auto done = writeStl(moved(*mesh, pose), folder / name); !done) return done;
    }
    return {};
}

Expected<void> writeGum(const TriangleMesh& mesh, const Pose& pose, const fs::path& file) {
    const TriangleMesh placed = moved(mesh, pose);
    if (auto done = writeStl(placed, file); !done) return done;
    fmt::print("{}: {}\n", shownName(file), meshSummary(reportOn(placed)));
    return {};
}

Expected<void> writeMouth(const MouthOptions& options) {
    if (auto done = makeFolder(options.out); !done) return done;
    const auto mouth = mouthAsWished(options.mouth);
    if (!mouth) return Unexpected{mouth.error()};
    std::size_t triangles = 0;
    for (const MouthTooth& tooth : mouth->teeth) {
        const fs::path folder = options.out / std::to_string(tooth.tooth.fdi);
        if (auto done = writeTooth(tooth.tooth, mouth->poseOf(tooth), folder); !done) return done;
        triangles += tooth.tooth.outer.triangles.size();
    }
    fmt::print("{} teeth in {}, each with outer.stl, enamel.stl, dentin.stl and pulp.stl; {} outer triangles in all\n",
               mouth->teeth.size(), shownName(options.out), triangles);
    if (auto done = writeGum(mouth->upperGingiva, {}, options.out / "gingiva-upper.stl"); !done) return done;
    if (auto done = writeGum(mouth->lowerGingiva, mouth->lowerJaw, options.out / "gingiva-lower.stl"); !done) {
        return done;
    }
    fmt::print("frame: +x to the patient's right, +y forward, +z up, mm; the jaw is {}\n", options.mouth.jaw);
    return {};
}

}  // namespace

Expected<BuiltinMouth> mouthAsWished(const MouthWishes& wishes) {
    for (const int fdi : wishes.missing) {
        if (isPermanentTooth(fdi)) continue;
        return unexpected(
            fmt::format("{} in --missing is no permanent tooth; FDI numbers are 11-18, 21-28, 31-38 and 41-48.", fdi));
    }
    const ToothCache cache(wishes.noCache ? fs::path() : usualCacheFolder());
    const MouthRequest request{wishes.triangles, wishes.seed, wishes.jaw == "open" ? JawPose::open : JawPose::closed,
                               wishes.missing};
    return cache.makeMouth(request);
}

int runMouth(const MouthOptions& options) {
    const auto done = writeMouth(options);
    return done ? kExitOk : refuse(done.error());
}

}  // namespace tactooth
