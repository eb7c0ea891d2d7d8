// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/contact_command.h"

#include <array>

#include "app/common/exit_code.h"
#include "app/cli/terminal/output.h"
#include "collision/proxy/contact_query.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_set.h"
#include "haptics/load_surface.h"
#include "session/io/csv_table.h"
#include "session/scripts/feel_run.h"
#include "session/io/finite_tick.h"

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
    FileSet files;
    for (const auto& input : {options.poses, options.tooth, options.tool}) files.reads(input);
    if (const auto opened = files.open(options.out); !opened) return refuse(opened.error());
    const auto trajectory = readTrajectory(options.poses);
    if (!trajectory) return refuse(trajectory.error());
    std::vector<Remark> remarks;
    const auto tooth = loadSurface(options.tooth, &remarks);
    if (!tooth) return refuse(tooth.error());
    const auto tool = loadTool(options.tool, &remarks);
    if (!tool) return refuse(tool.error());
    printRemarks(remarks);
    auto file = CsvWriter::create(options.out, kColumns);
    if (!file) return refuse(file.error());

    ContactQuery query(*tool, *tooth);
    std::size_t touching = 0;
    for (const TimedPose& row : *trajectory) {
        double micros = 0;
        const Contact contact = timed(micros, [&] { return query.at(row.toolInTooth); });
        if (const auto finite = checkFinite(row.time, contact); !finite) return refuse(finite.error());
        touching += contact.touching ? 1 : 0;
        writeRow(*file, row.time, contact, micros);
    }
    if (const auto done = file->commit(); !done) return refuse(done.error());
    if (const auto done = files.commit(); !done) return refuse(done.error());
    if (!(*tooth)->closed) say("The tooth is not closed: only its triangles count, nothing is inside.\n");
    say("{} poses, {} of them touching, written to {}\n", trajectory->size(), touching, shownName(options.out));
    return kExitOk;
}

}  // namespace tactooth
