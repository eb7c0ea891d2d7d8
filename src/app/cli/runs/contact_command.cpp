// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/contact_command.h"

#include <array>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "collision/proxy/contact_query.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "haptics/load_surface.h"
#include "session/cases/bur_by_name.h"
#include "session/io/csv_table.h"
#include "session/io/finite_tick.h"
#include "session/scripts/touch_run.h"

namespace tactooth {
namespace {

constexpr std::array<std::string_view, 11> kColumns = {"t",  "touching", "depth", "nx",       "ny",    "nz",
                                                       "px", "py",       "pz",    "contacts", "micros"};

void writeRow(CsvWriter& file, double time, const Contact& contact, double micros) {
    const Vec3& n = contact.normal;
    const Vec3& p = contact.point;
    file.row(std::array<double, kColumns.size()>{time, contact.touching ? 1.0 : 0.0, contact.depth, n.x(), n.y(), n.z(),
                                                 p.x(), p.y(), p.z(), static_cast<double>(contact.contacts), micros});
}

}  // namespace

int runContact(const ContactOptions& options) {
    FileTransaction files;
    for (const auto& input : {options.poses, options.tooth, options.tool}) files.reads(input);
    if (const auto opened = files.open(options.out); !opened) return reportError(opened.error());
    const auto trajectory = readTrajectory(options.poses);
    if (!trajectory) return reportError(trajectory.error());
    std::vector<ImportNote> importNotes;
    const auto tooth = loadSurface(options.tooth, &importNotes);
    if (!tooth) return reportError(tooth.error());
    const auto tool = findOrLoadTool(options.tool, &importNotes);
    if (!tool) return reportError(tool.error());
    printImportNotes(importNotes);
    auto file = CsvWriter::create(options.out, kColumns);
    if (!file) return reportError(file.error());

    ContactQuery query(*tool, *tooth);
    std::size_t touching = 0;
    for (const TimedPose& row : *trajectory) {
        double micros = 0;
        const Contact contact = timed(micros, [&] { return query.at(row.toolInTooth); });
        if (const auto finite = checkFinite(row.time, contact); !finite) return reportError(finite.error());
        touching += contact.touching ? 1 : 0;
        writeRow(*file, row.time, contact, micros);
    }
    if (const auto done = file->commit(); !done) return reportError(done.error());
    if (const auto done = files.commit(); !done) return reportError(done.error());
    if (!(*tooth)->closed) print("The tooth is not closed: only its triangles count, nothing is inside.\n");
    print("{} poses, {} of them touching, written to {}\n", trajectory->size(), touching, displayName(options.out));
    return kExitOk;
}

}  // namespace tactooth
