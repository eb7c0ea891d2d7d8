// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/bench_cut_command.h"

#include <fmt/core.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "experiments/cut_timing.h"
#include "experiments/standard_teeth.h"
#include "session/io/run_metadata.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMillimetre = 1e-3;  // one micrometre in mm

/// Writes the cases one by one (table) or all at the end (JSON).
class CutOutput {
public:
    CutOutput(bool json, int cores, const StandardTooth& tooth) : isJson_(json) {
        const RunMetadata facts = currentRunMetadata();
        if (isJson_) {
            json_ = {
                {"machine", facts.machine},
                {"compiler", facts.compiler},
                {"commit", facts.commit},
                {"command", facts.command},
                {"date", facts.date},
                {"clock", cores > 1 ? "of the carving thread: as it passes; else processor time" : "processor time"},
                {"cutter_cores", cores},
                {"tooth", tooth.name},
                {"source", tooth.source},
                {"triangles", tooth.mesh.triangles.size()},
                {"cases", Json::array()}};
            return;
        }
        print("machine:  {}\ncompiler: {}\ncommit:   {}\ncommand:  {}\n", facts.machine, facts.compiler, facts.commit,
              facts.command);
        print("tooth:    {}, {}, {} triangles\n", tooth.name, tooth.source, tooth.mesh.triangles.size());
        print(
            "A bur goes into the tooth, its whole head deep, and mills slots at the speed of the hand.\n"
            "{}: tick, us; update (carve and new surface), ms; felt: from a tick in which\n"
            "the bur works to the tick that feels what it cut, and from the beginning of that carve, ms; ns for each "
            "voxel\n"
            "of removed volume; ahead: what the thread that makes bricks ahead of the bur takes of a core, %.\n\n",
            cores > 1 ? fmt::format("Processor time, of the carving thread the time that passes on {} cores", cores)
                      : "Processor time of one core for each");
        print(
            "{:<22} {:>5} {:>6} {:>6} {:>6} {:>6} {:>6} | {:>6} {:>6} {:>6} {:>6} | {:>5} {:>5} {:>6} {:>5} | {:>6} "
            "{:>5} {:>6} {:>7} {:>5} {:>5}\n",
            "bur", "voxel", "mm/s", "p50", "p99", "p99.9", "max", "up p50", "p99", "max", "1/s", "felt", "p99",
            "carved", "p99", "first", "ahead", "mm^3", "ns/vox", "MB", "all");
    }

    void add(const CutCase& c, const CutTiming& t) {
        if (!isJson_) {
            print(
                "{:<22} {:>5.0f} {:>6.1f} {:>6.0f} {:>6.0f} {:>6.0f} {:>6.0f} | {:>6.1f} {:>6.1f} {:>6.1f} "
                "{:>6.0f} | {:>5.1f} {:>5.1f} {:>6.1f} {:>5.1f} | {:>6.1f} {:>5.0f} {:>6.2f} {:>7.0f} {:>5.0f} "
                "{:>5.0f}\n",
                nameOf(c), c.voxel / kMillimetre, c.speed, t.p50, t.p99, t.p999, t.largest, t.updateP50, t.updateP99,
                t.updateLargest, t.updatesPerSecond, t.touchP50, t.touchP99, t.carvedP50, t.carvedP99, t.firstUpdate,
                100 * t.prefetchShare, t.removed, t.nanosPerVoxel, t.brickMegabytes, t.residentMegabytes);
            std::fflush(stdout);
            return;
        }
        json_["cases"].push_back({{"bur", nameOf(c)},
                                  {"diameter_mm", c.bur.headDiameter},
                                  {"depth_mm", c.engagement * c.bur.headLength},
                                  {"voxel_um", c.voxel / kMillimetre},
                                  {"mm_per_s", c.speed},
                                  {"removal_factor", c.removal},
                                  {"ticks", t.ticks},
                                  {"tick_p50_us", t.p50},
                                  {"tick_p99_us", t.p99},
                                  {"tick_p999_us", t.p999},
                                  {"tick_max_us", t.largest},
                                  {"updates", t.updates},
                                  {"update_p50_ms", t.updateP50},
                                  {"update_p99_ms", t.updateP99},
                                  {"update_max_ms", t.updateLargest},
                                  {"updates_per_s", t.updatesPerSecond},
                                  {"lists", t.lists},
                                  {"list_p50_ms", t.listP50},
                                  {"felt_p50_ms", t.touchP50},
                                  {"felt_p99_ms", t.touchP99},
                                  {"carve_to_felt_p50_ms", t.carvedP50},
                                  {"carve_to_felt_p99_ms", t.carvedP99},
                                  {"first_update_ms", t.firstUpdate},
                                  {"maker_share", t.prefetchShare},
                                  {"removed_mm3", t.removed},
                                  {"ns_per_voxel", t.nanosPerVoxel},
                                  {"brick_megabytes", t.brickMegabytes},
                                  {"resident_megabytes", t.residentMegabytes},
                                  {"deepest_mm", t.deepest}});
    }

    void end() {
        if (isJson_) print("{}\n", json_.dump(1, ' ', false, Json::error_handler_t::replace));
    }

private:
    static std::string nameOf(const CutCase& c) {
        const char* material = c.removal > 1 ? "" : ", enamel";
        return fmt::format("{} {:.1f} x {:.1f}{}", c.bur.kind == BurKind::Round ? "round" : "fissure",
                           c.bur.headDiameter, c.engagement * c.bur.headLength, material);
    }

    bool isJson_;
    Json json_;
};

/// The burs of the targets, one of them at the slow feed that sound enamel allows. Then round burs of all sizes and
/// voxels.
std::vector<CutCase> casesOf(const BenchCutOptions& options) {
    std::vector<CutCase> cases;
    if (options.voxels.empty() && options.diameters.empty()) {
        cases.push_back({.bur = *findBur("57"), .strokes = 3});
        cases.push_back({.bur = *findBur("57"), .strokes = 3, .engagement = 0.5});
        cases.push_back({.bur = roundBur(1.0), .speed = 1, .stroke = 1, .strokes = 1, .removal = 1});
    }
    const std::vector<double> voxels = options.voxels.empty() ? std::vector<double>{100, 50, 25, 15} : options.voxels;
    const std::vector<double> diameters =
        options.diameters.empty() ? std::vector<double>{0.5, 1.0, 1.4, 1.8, 2.3} : options.diameters;
    for (const double voxel : voxels) {
        for (const double diameter : diameters) {
            cases.push_back({.bur = roundBur(diameter), .voxel = voxel * kMillimetre});
        }
    }
    return cases;
}

}  // namespace

int runBenchCut(const BenchCutOptions& options) {
    const auto tooth = options.tooth.empty() ? standardTooth(StandardToothKind::Large) : customTooth(options.tooth);
    if (!tooth) return reportError(tooth.error());
    const auto whole = uncut(*tooth);
    if (!whole) return reportError(whole.error());
    CutOutput output(options.json, options.cores, *tooth);
    for (CutCase one : casesOf(options)) {
        one.cores = options.cores;
        output.add(one, timeCutting(*whole, one));
    }
    output.end();
    return kExitOk;
}

}  // namespace tactooth
