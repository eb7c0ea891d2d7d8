// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/shapes/mouth_command.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

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

namespace fs = std::filesystem;

constexpr std::array kLayerFiles = {"outer.stl", "enamel.stl", "dentin.stl", "pulp.stl"};
constexpr std::array kGumFiles = {"gingiva-upper.stl", "gingiva-lower.stl"};

/// Opens all output files before the teeth are made.
Expected<void> openAll(const MouthOptions& options, FileTransaction& files) {
    if (auto done = files.makeFolder(options.out); !done) return done;
    for (int fdi = 11; fdi <= 48; ++fdi) {
        if (!isPermanentTooth(fdi) || std::ranges::count(options.mouth.missing, fdi) > 0) continue;
        const fs::path folder = options.out / std::to_string(fdi);
        if (auto done = files.makeFolder(folder); !done) return done;
        for (const char* name : kLayerFiles) {
            if (auto done = files.open(folder / name); !done) return done;
        }
    }
    for (const char* name : kGumFiles) {
        if (auto done = files.open(options.out / name); !done) return done;
    }
    return {};
}

Expected<void> writeTooth(const BuiltinTooth& tooth, const Pose& pose, const fs::path& folder) {
    const std::array meshes = {&tooth.outer, &tooth.enamel, &tooth.dentin, &tooth.pulp};
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (auto done = writeStl(transformed(*meshes[i], pose), folder / kLayerFiles[i]); !done) return done;
    }
    return {};
}

Expected<void> writeMouth(const MouthOptions& options) {
    FileTransaction files;
    if (auto done = openAll(options, files); !done) return done;
    const auto mouth = mouthFromSpec(options.mouth);
    if (!mouth) return Unexpected{mouth.error()};
    std::size_t triangles = 0;
    for (const MouthTooth& tooth : mouth->teeth) {
        const fs::path folder = options.out / std::to_string(tooth.tooth.fdi);
        if (auto done = writeTooth(tooth.tooth, mouth->poseOf(tooth), folder); !done) return done;
        triangles += tooth.tooth.outer.triangles.size();
    }
    const std::array gums = {mouth->upperGingiva, transformed(mouth->lowerGingiva, mouth->lowerJaw)};
    for (std::size_t i = 0; i < gums.size(); ++i) {
        if (auto done = writeStl(gums[i], options.out / kGumFiles[i]); !done) return done;
    }
    if (auto done = files.commit(); !done) return done;
    print("{} teeth in {}, each with outer.stl, enamel.stl, dentin.stl and pulp.stl; {} outer triangles in all\n",
          mouth->teeth.size(), displayName(options.out), triangles);
    for (std::size_t i = 0; i < gums.size(); ++i) {
        print("{}: {}\n", displayName(options.out / kGumFiles[i]), meshSummary(reportOn(gums[i])));
    }
    print("frame: +x to the patient's right, +y forward, +z up, mm; the jaw is {}\n", options.mouth.jaw);
    return {};
}

}  // namespace

Expected<BuiltinMouth> mouthFromSpec(const MouthSpec& spec) {
    for (const int fdi : spec.missing) {
        if (isPermanentTooth(fdi)) continue;
        return unexpected(msg::kMissingNotPermanent, fdi);
    }
    const ToothCache cache(spec.noCache ? fs::path() : defaultCacheFolder());
    const MouthRequest request{spec.triangles, spec.seed, spec.jaw == "open" ? JawPose::Open : JawPose::Closed,
                               spec.missing};
    return cache.makeMouth(request);
}

int runMouth(const MouthOptions& options) {
    const auto done = writeMouth(options);
    return done ? kExitOk : reportError(done.error());
}

}  // namespace tactooth
