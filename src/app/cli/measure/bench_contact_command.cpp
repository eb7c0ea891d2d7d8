// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/bench_contact_command.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "experiments/contact_timing.h"
#include "experiments/standard_teeth.h"
#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_file.h"
#include "geometry/mesh/mesh_report.h"
#include "session/io/run_metadata.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

struct Case {
    const StandardTooth& tooth;
    int percent;
    std::size_t triangles;
    double speed;  // mm/s
    ContactTiming timing;
};

/// Writes the cases one by one (table) or all at the end (JSON).
class BenchOutput {
public:
    BenchOutput(const BenchContactOptions& options, const std::string& tool, std::size_t toolTriangles)
        : isJson_(options.json) {
        const RunMetadata facts = currentRunMetadata();
        if (isJson_) {
            json_ = {{"machine", facts.machine},
                     {"compiler", facts.compiler},
                     {"commit", facts.commit},
                     {"command", facts.command},
                     {"date", facts.date},
                     {"clock", "processor time of the thread"},
                     {"tool", tool},
                     {"tool_triangles", toolTriangles},
                     {"degrees_of_freedom", options.freedom},
                     {"repeat", options.repeat},
                     {"turning_degrees_per_s", ToolTrajectory{}.turn},
                     {"cases", Json::array()}};
            return;
        }
        print("machine:  {}\ncompiler: {}\ncommit:   {}\ncommand:  {}\n", facts.machine, facts.compiler, facts.commit,
              facts.command);
        print("tool:     {}, {} triangles\n", tool, toolTriangles);
        print(
            "Microseconds of processor time a tick of 1 ms, least of {} runs; p50 to p99.9 of the ticks in contact, "
            "max of all.\nThe hand turns the tool {:.0f} degrees/s about its tip; the tool has {} degrees of "
            "freedom.\n\n",
            options.repeat, ToolTrajectory{}.turn, options.freedom);
        print("{:<14} {:>4} {:>9} {:>5} {:>6} {:>7} {:>7} {:>7} {:>7} {:>8} {:>6} {:>5}\n", "tooth", "%", "triangles",
              "cm/s", "ticks", "p50", "p99", "p99.9", "max", "contacts", "rounds", "gjk");
    }

    void add(const Case& c) {
        const ContactTiming& t = c.timing;
        if (!isJson_) {
            print("{:<14} {:>4} {:>9} {:>5.0f} {:>6} {:>7.1f} {:>7.1f} {:>7.1f} {:>7.1f} {:>8.2f} {:>6.2f} {:>5.1f}\n",
                  c.tooth.name, c.percent, c.triangles, c.speed / 10, t.ticks, t.p50, t.p99, t.p999, t.largest,
                  t.contacts, t.iterations, t.distances);
            std::fflush(stdout);
            return;
        }
        json_["cases"].push_back({{"tooth", c.tooth.name},
                                  {"source", c.tooth.source},
                                  {"percent", c.percent},
                                  {"triangles", c.triangles},
                                  {"mm_per_s", c.speed},
                                  {"ticks", t.ticks},
                                  {"in_contact", t.inContact},
                                  {"p50_us", t.p50},
                                  {"p99_us", t.p99},
                                  {"p999_us", t.p999},
                                  {"max_us", t.largest},
                                  {"contacts", t.contacts},
                                  {"rounds", t.iterations},
                                  {"gjk_runs", t.distances},
                                  {"out_of_rounds", t.iterationLimitHits},
                                  {"overlapping", t.overlapping}});
    }

    void end() {
        if (isJson_) print("{}\n", json_.dump(1, ' ', false, Json::error_handler_t::replace));
    }

private:
    bool isJson_;
    Json json_;
};

void benchTooth(const StandardTooth& tooth, const std::shared_ptr<const ToolShape>& tool,
                const BenchContactOptions& options, std::span<const int> percents, BenchOutput& output) {
    print(options.json ? stderr : stdout, "{}: {}\n", tooth.name, tooth.source);
    const Freedom freedom = options.freedom == 6 ? Freedom::TranslationAndRotation : Freedom::Translation;
    for (Resolution& resolution : resolutionLadder(tooth.mesh, percents)) {
        const std::size_t triangles = resolution.mesh.triangles.size();
        const auto surface = plainSurface(std::move(resolution.mesh));
        for (const double speed : {kSlowSpeed, kFastSpeed}) {
            const std::vector<Pose> hand = toolTrajectory(surface->base->mesh(), standardToolPath(speed));
            output.add({tooth, resolution.percent, triangles, speed,
                        timeContact(surface, tool, hand, options.repeat, freedom)});
        }
    }
}

/// The requested percentages, ascending and without duplicates.
std::vector<int> percentsOf(const BenchContactOptions& options) {
    std::vector<int> percents = options.resolutions;
    if (percents.empty()) percents.assign(kResolutions.begin(), kResolutions.end());
    std::ranges::sort(percents);
    percents.erase(std::unique(percents.begin(), percents.end()), percents.end());
    return percents;
}

}  // namespace

int runBenchContact(const BenchContactOptions& options) {
    TriangleMesh bur;
    std::string burName = "round bur 4, built in";
    if (options.tool.empty()) {
        bur = standardBur();
    } else {
        auto mesh = loadMesh(options.tool);
        if (!mesh) return reportError(mesh.error());
        bur = std::move(*mesh);
        burName = displayName(options.tool);
    }
    std::optional<StandardTooth> own;
    if (!options.tooth.empty()) {
        auto tooth = customTooth(options.tooth);
        if (!tooth) return reportError(tooth.error());
        own = std::move(*tooth);
    }
    const std::vector<int> percents = percentsOf(options);
    if (own && percents.front() < 100 && !reportOn(own->mesh).watertight()) {
        return reportError({msg::kToothNotClosed, displayName(options.tooth)});
    }
    const auto tool = std::make_shared<const ToolShape>(std::move(bur));
    BenchOutput output(options, burName, tool->mesh().triangles.size());
    if (own) {
        benchTooth(*own, tool, options, percents, output);
    } else {
        for (const StandardToothKind kind : kStandardTeeth) {
            const auto tooth = standardTooth(kind);
            if (!tooth) return reportError(tooth.error());
            benchTooth(*tooth, tool, options, percents, output);
        }
    }
    output.end();
    return kExitOk;
}

}  // namespace tactooth
