// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/mesh/info_command.h"

#include <cstdio>

#include "app/cli/terminal/info_text.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_file.h"

namespace tactooth {
namespace {

/// Moves the report on the surface to the coordinates of its file.
MeshReport movedBy(MeshReport report, const Vec3& offset) {
    report.box.translate(offset);
    for (ShellReport& shell : report.shells) shell.box.translate(offset);
    return report;
}

}  // namespace

int runInfo(const InfoOptions& options) {
    int exitCode = kExitOk;
    bool first = true;
    for (const std::filesystem::path& file : options.files) {
        const Expected<ReadMesh> read = readMesh(file);
        if (!read) {
            exitCode = reportError(read.error());
            continue;
        }
        SurfaceFacts facts = surfaceFacts(read->mesh);
        facts.used = movedBy(std::move(facts.used), read->offset);
        facts.reading = read->importNotes;
        const std::string name = displayName(file);
        if (!options.json && !first) std::puts("");
        writeTo(stdout, options.json ? infoJson(name, facts) : infoTable(name, facts));
        first = false;
    }
    return exitCode;
}

}  // namespace tactooth
