// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/bench_slot_command.h"

#include <nlohmann/json.hpp>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "experiments/slot_timing.h"
#include "experiments/standard_teeth.h"
#include "session/io/run_metadata.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMillimetre = 1e-3;  // one micrometre in mm
constexpr double kDepth = 2;          // of the slot, mm

struct SlotTool {
    const char* name;
    std::vector<SlotTiming> timings;
};

Json jsonOf(const SlotTool& tool) {
    Json rows = Json::array();
    for (const SlotTiming& t : tool.timings) {
        rows.push_back({{"tool", tool.name},
                        {"motion", slotMotionName(t.motion)},
                        {"ticks", t.ticks},
                        {"tick_p50_us", t.p50},
                        {"tick_p99_us", t.p99},
                        {"tick_p999_us", t.p999},
                        {"tick_max_us", t.largest},
                        {"force_n", t.force},
                        {"noise_n", t.noise},
                        {"sunk_um", t.sunk / kMillimetre},
                        {"leaves", t.leaves}});
    }
    return rows;
}

void printTable(const std::vector<SlotTool>& tools) {
    print(
        "\nA fissure bur of 1.0 mm has cut a slot 2 mm deep. With its spindle still it, and then a probe, is pressed\n"
        "0.2 mm into the floor. Processor time of a tick, us; noise: largest difference of a force from the mean.\n\n"
        "{:<8} {:<10} {:>6} {:>6} {:>6} {:>6} | {:>7} {:>9} {:>8}  {}\n",
        "tool", "it", "p50", "p99", "p99.9", "max", "force N", "noise mN", "sunk um", "leaves");
    for (const SlotTool& tool : tools) {
        for (const SlotTiming& t : tool.timings) {
            print("{:<8} {:<10} {:>6.0f} {:>6.0f} {:>6.0f} {:>6.0f} | {:>7.3f} {:>9.2f} {:>8.2f}  {}\n", tool.name,
                  slotMotionName(t.motion), t.p50, t.p99, t.p999, t.largest, t.force, 1e3 * t.noise,
                  t.sunk / kMillimetre, t.leaves ? "yes" : "NO");
        }
    }
}

}  // namespace

int runBenchSlot(const BenchSlotOptions& options) {
    const auto tooth = options.tooth.empty() ? standardTooth(StandardToothKind::Large) : customTooth(options.tooth);
    if (!tooth) return reportError(tooth.error());
    const auto whole = uncut(*tooth);
    if (!whole) return reportError(whole.error());
    const auto measured = [&](bool probe) {
        return timeInSlot(*whole, *findBur("57"), kDepth, options.voxel * kMillimetre, probe);
    };
    const std::vector<SlotTool> tools = {{"bur", measured(false)}, {"probe", measured(true)}};

    const RunMetadata facts = currentRunMetadata();
    if (!options.json) {
        print("machine:  {}\ncompiler: {}\ncommit:   {}\ncommand:  {}\n", facts.machine, facts.compiler, facts.commit,
              facts.command);
        print("tooth:    {}, {}, {} triangles, voxel {} um\n", tooth->name, tooth->source, tooth->mesh.triangles.size(),
              options.voxel);
        printTable(tools);
        return kExitOk;
    }
    Json json = {{"machine", facts.machine},  {"compiler", facts.compiler},
                 {"commit", facts.commit},    {"command", facts.command},
                 {"date", facts.date},        {"tooth", tooth->name},
                 {"source", tooth->source},   {"triangles", tooth->mesh.triangles.size()},
                 {"voxel_um", options.voxel}, {"cases", Json::array()}};
    for (const SlotTool& tool : tools) {
        for (const Json& row : jsonOf(tool)) json["cases"].push_back(row);
    }
    print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
    return kExitOk;
}

}  // namespace tactooth
