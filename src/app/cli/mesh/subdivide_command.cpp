// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/mesh/subdivide_command.h"

#include <fmt/core.h>

#include <cmath>

#include "app/cli/terminal/mesh_summary.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "collision/bvh/mesh_deviation.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/io/mesh_file.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/subdivide.h"

namespace tactooth {

int runSubdivide(const SubdivideOptions& options) {
    FileTransaction files;
    files.reads(options.in);
    if (const auto opened = files.open(options.out); !opened) return reportError(opened.error());
    const auto read = readMesh(options.in);
    if (!read) return reportError(read.error());
    printImportNotes(read->importNotes);
    const TriangleMesh* const mesh = &read->mesh;
    const int times = options.times.value_or(1);
    const double wanted = options.triangles ? static_cast<double>(*options.triangles)
                                            : static_cast<double>(mesh->triangles.size()) * std::pow(4.0, times);
    if (wanted > static_cast<double>(kMaxSubdivided)) {
        return reportError(
            {msg::kTooManyTriangles, displayName(options.in), fmt::format("{:.0f}", wanted), kMaxSubdivided});
    }
    print(stderr, "subdividing {} triangles to {:.0f}\n", mesh->triangles.size(), wanted);
    const TriangleMesh more = options.triangles ? subdividedTo(*mesh, *options.triangles) : subdivided(*mesh, times);
    if (const auto done = writeStl(more, options.out); !done) return reportError(done.error());
    if (const auto done = files.commit(); !done) return reportError(done.error());
    printChange(options.in, *mesh, options.out, more, maxVertexDistance(more, *mesh));
    return kExitOk;
}

}  // namespace tactooth
