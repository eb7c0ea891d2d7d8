// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Touching: time of one tick of the proxy (1 ms of hand motion) while a bur comes down on a tooth, is pressed 0.3 mm
// into it, slides over cusps and fissures and is taken away, the hand turning 60 degrees/s all the time. Times are the
// thread's own processor time, so that other work on the machine counts as little as possible. One CSV line a case.
// Usage: contact_bench [--repeat N] [--only TEXT] (run it with the real teeth beside the source tree or in
// $TACTOOTH_DATA).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

#include "collision/contact_query.h"
#include "geometry/mesh_file.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_shape.h"
#include "support/hand_path.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

struct Model {
    std::string name;
    TriangleMesh mesh;
};

double threadMicros() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

double wallMillis() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

std::vector<Model> teeth() {
    std::vector<Model> models;
    if (const auto folder = test::realTeethFolder()) {
        for (const char* file : {"microct-meshes/tooth_2_outer.stl", "openmandible/whole/L1_whole.stl",
                                 "openmandible/whole/L3_whole.stl", "openmandible/whole/L6_whole.stl"}) {
            const double start = wallMillis();
            auto mesh = loadMesh(*folder / file);
            if (!mesh) continue;
            const double loaded = wallMillis();
            const AabbTree tree(*mesh);
            std::printf("# %s: %zu triangles, load and weld %.1f ms, tree %.1f ms\n", file, mesh->triangles.size(),
                        loaded - start, wallMillis() - loaded);
            models.push_back({std::filesystem::path(file).stem(), std::move(*mesh)});
        }
    }
    if (models.empty()) {
        for (const auto kind : {BuiltinToothKind::lowerFirstMolar, BuiltinToothKind::upperCanine}) {
            BuiltinTooth tooth = makeBuiltinTooth(kind);
            models.push_back({tooth.name, std::move(tooth.outer)});
        }
    }
    return models;
}

std::vector<Model> tools() {
    std::vector<Model> models;
    for (const char* number : {"4", "557"}) {
        if (const auto spec = findBur(number)) models.push_back({"bur " + spec->number, makeBur(*spec).surface});
    }
    if (const auto folder = test::realTeethFolder()) {
        if (auto mesh = loadMesh(*folder / "tools/bur_tapered.stl"))
            models.push_back({"bur_tapered", std::move(*mesh)});
    }
    return models;
}

/// Value at `share` of the sorted values.
double quantile(std::vector<double>& values, double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

void runCase(const Model& tooth, const std::shared_ptr<const Surface>& surface, const Model& tool, double speed,
             int repeat) {
    const auto shape = std::make_shared<const ToolShape>(tool.mesh);
    test::HandPath path;
    path.speed = speed;
    path.strokes = speed > 50 ? 12 : 4;
    const std::vector<Pose> hand = test::handPath(tooth.mesh, path);
    std::vector<double> micros(hand.size(), 1e30);
    double rounds = 0;
    double distances = 0;
    double pairs = 0;
    std::size_t held = 0;
    std::size_t overlapping = 0;
    for (int run = 0; run < repeat; ++run) {
        SlidingBody body(shape);
        body.setSurface(surface);
        body.placeAt(hand.front());
        for (std::size_t i = 0; i < hand.size(); ++i) {
            const double start = threadMicros();
            const MoveResult result = body.moveToward(hand[i]);
            micros[i] = std::min(micros[i], threadMicros() - start);
            rounds += result.rounds;
            distances += result.distances;
            pairs += static_cast<double>(body.listedPairs());
            held += result.contactCount > 0 ? 1 : 0;
            overlapping += result.status == MoveStatus::Overlapping ? 1 : 0;
        }
    }
    const double ticks = static_cast<double>(hand.size()) * repeat;
    std::printf("%s,%s,%zu,%g,%zu,%.2f,%.1f,%.1f,%.1f,%.1f,%.2f,%.2f,%.0f,%zu\n", tooth.name.c_str(), tool.name.c_str(),
                tool.mesh.triangles.size(), speed, hand.size(), static_cast<double>(held) / ticks,
                quantile(micros, 0.5), quantile(micros, 0.99), quantile(micros, 0.999), quantile(micros, 1),
                rounds / ticks, distances / ticks, pairs / ticks, overlapping);
    std::fflush(stdout);
}

int run(int repeat, const std::string& only) {
    const std::vector<Model> bur = tools();
    const std::vector<Model> models = teeth();
    std::printf(
        "tooth,tool,tool_triangles,mm_per_s,ticks,held,p50_us,p99_us,p999_us,max_us,rounds,gjk,pairs,overlaps\n");
    for (const Model& tooth : models) {
        auto surface = std::make_shared<Surface>();
        surface->base = std::make_shared<const SurfacePart>(tooth.mesh);
        for (const Model& tool : bur) {
            for (const double speed : {10.0, 100.0}) {
                if ((tooth.name + "/" + tool.name).find(only) == std::string::npos) continue;
                runCase(tooth, surface, tool, speed, repeat);
            }
        }
    }
    return 0;
}

}  // namespace
}  // namespace tactooth

int main(int count, char** arguments) {
    int repeat = 3;
    std::string only;
    for (int i = 1; i + 1 < count; i += 2) {
        if (std::strcmp(arguments[i], "--repeat") == 0) repeat = std::max(1, std::atoi(arguments[i + 1]));
        if (std::strcmp(arguments[i], "--only") == 0) only = arguments[i + 1];
    }
    return tactooth::run(repeat, only);
}
