// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/shapes/bur_command.h"

#include <fmt/core.h>

#include "app/cli/terminal/mesh_summary.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/file_bytes.h"
#include "geometry/io/stl_writer.h"
#include "instruments/contra_angle.h"
#include "instruments/hand_instruments.h"
#include "instruments/low_speed_handpiece.h"
#include "instruments/mirror.h"
#include "instruments/turbine.h"

namespace tactooth {
namespace {

std::string edgeOf(const BurSpec& spec) {
    if (spec.material == BurMaterial::Diamond) return fmt::format("{:.0f} um", spec.gritMicrometres);
    return fmt::format("{} blades", spec.flutes);
}

int printList() {
    print("{:<9}{:<21}{:>5}{:>7}{:>7}  {:<10}{}\n", "number", "ISO 6360", "mm", "long", "taper", "cuts with", "name");
    for (const BurSpec& spec : burCatalogue()) {
        print("{:<9}{:<21}{:>5.1f}{:>7.2f}{:>7.0f}  {:<10}{}\n", spec.number, isoNumber(spec), spec.headDiameter,
              spec.headLength, spec.taperDegrees, edgeOf(spec), spec.name);
    }
    return kExitOk;
}

}  // namespace

int runBur(const BurOptions& options) {
    if (options.list) return printList();
    if (options.number.empty()) return reportError(msg::kNoBurNamed);
    const auto spec = findBur(options.number);
    if (!spec) {
        return reportError({msg::kBurNotListed, options.number});
    }
    if (options.out.empty()) return reportError(msg::kOutMissing);
    const Bur bur = makeBurWithTriangles(*spec, options.triangles);
    if (const auto done = writeStl(bur.surface, options.out); !done) return reportError(done.error());
    print("{} (ISO {}), head {:.2f} x {:.2f} mm\n{}: {}\n", spec->name, isoNumber(*spec), spec->headDiameter,
          spec->headLength, displayName(options.out), meshSummary(reportOn(bur.surface)));
    return kExitOk;
}

int runInstrument(const InstrumentOptions& options) {
    TriangleMesh mesh;
    if (options.name == "turbine") mesh = makeTurbine(options.triangles);
    if (options.name == "contra-angle") mesh = makeContraAngle(options.triangles);
    if (options.name == "low-speed") mesh = makeLowSpeedHandpiece(options.triangles);
    if (options.name == "mirror-22") mesh = makeMirror(22).surface;
    if (options.name == "mirror-24") mesh = makeMirror(24).surface;
    if (options.name == "explorer") mesh = makeExplorer();
    if (options.name == "excavator") mesh = makeSpoonExcavator();
    if (options.name == "probe") mesh = makePeriodontalProbe();
    if (const auto done = writeStl(mesh, options.out); !done) return reportError(done.error());
    print("{}: {}\n", displayName(options.out), meshSummary(reportOn(mesh)));
    return kExitOk;
}

}  // namespace tactooth
