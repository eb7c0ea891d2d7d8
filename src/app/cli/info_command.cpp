// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/info_command.h"

#include <cstdio>

#include "app/cli/exit_code.h"
#include "app/cli/info_text.h"
#include "app/cli/output.h"
#include "geometry/file_bytes.h"
#include "geometry/mesh_file.h"

namespace tactooth {

int runInfo(const InfoOptions& options) {
    int exitCode = kExitOk;
    bool first = true;
    for (const std::filesystem::path& file : options.files) {
        const Expected<TriangleMesh> mesh = loadMesh(file);
        if (!mesh) {
            exitCode = refuse(mesh.error());
            continue;
        }
        const SurfaceFacts facts = surfaceFacts(*mesh);
        const std::string name = shownName(file);
        if (!options.json && !first) std::puts("");
        writeTo(stdout, options.json ? infoJson(name, facts) : infoTable(name, facts));
        first = false;
    }
    return exitCode;
}

}  // namespace tactooth
