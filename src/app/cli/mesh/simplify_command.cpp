// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/mesh/simplify_command.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdio>

#include "app/cli/terminal/mesh_summary.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "collision/bvh/mesh_deviation.h"
#include "collision/solid/solid_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/simplify.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

/// Number of `triangles` to keep, from "50%" or "20000".
Expected<std::size_t> wantedTriangles(std::string_view keep, std::size_t triangles) {
    const bool isShare = keep.ends_with('%');
    const auto number = toNumber<double>(isShare ? keep.substr(0, keep.size() - 1) : keep);
    if (!number || !(*number > 0) || !(isShare ? *number <= 100 : *number == std::floor(*number) && *number < 1e15)) {
        return unexpected(msg::kKeepUnknown, quotedWord(keep));
    }
    const double wanted = isShare ? *number / 100 * static_cast<double>(triangles) : *number;
    return static_cast<std::size_t>(std::llround(wanted));
}

}  // namespace

int runSimplify(const SimplifyOptions& options) {
    FileTransaction files;
    files.reads(options.in);
    if (const auto opened = files.open(options.out); !opened) return reportError(opened.error());
    if (const auto wanted = wantedTriangles(options.keep, 1); !wanted) return reportError(wanted.error());
    std::vector<ImportNote> importNotes;
    auto mesh = loadSolid(options.in, msg::kTheSurface, {.dropsSpecks = false}, &importNotes);
    if (!mesh) return reportError(mesh.error());
    printImportNotes(importNotes);
    std::erase_if(mesh->triangles, [](const Triangle& triangle) { return isDegenerate(triangle); });
    const std::size_t wanted = *wantedTriangles(options.keep, mesh->triangles.size());
    print(stderr, "simplifying {} triangles to {}\n", mesh->triangles.size(), wanted);
    const TriangleMesh fewer = simplified(*mesh, wanted);
    if (const SolidReport now = examineSolid(fewer, {.dropsSpecks = false}).report; !now.isSolid()) {
        return reportError({msg::kSimplifiedCrossing, displayName(options.in), fewer.triangles.size(),
                            fmt::format("{:.2f}", now.overlap)});
    }
    if (const auto done = writeStl(fewer, options.out); !done) return reportError(done.error());
    if (const auto done = files.commit(); !done) return reportError(done.error());
    printChange(options.in, *mesh, options.out, fewer, hausdorffDistance(*mesh, fewer));
    if (fewer.triangles.size() > wanted) {
        print("more triangles than asked for are needed to keep the surface closed and its triangles well shaped\n");
    }
    return kExitOk;
}

}  // namespace tactooth
