// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "collision/bvh/aabb_tree.h"
#include "experiments/experiments.h"
#include "experiments/published.h"
#include "experiments/thread_clock.h"
#include "geometry/io/mesh_file.h"
#include "geometry/io/stl_writer.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr int kRepeat = 5;  // the first run warms the file cache, as for the second start of a program

struct LoadTime {
    double read = std::numeric_limits<double>::infinity();  // ms: file to welded mesh
    double tree = std::numeric_limits<double>::infinity();  // ms: mesh to AABB tree
    [[nodiscard]] double total() const { return read + tree; }
};

Expected<LoadTime> timeLoading(const std::filesystem::path& file) {
    LoadTime best;
    for (int run = 0; run < kRepeat; ++run) {
        const double start = wallMillis();
        const auto mesh = loadMesh(file);
        if (!mesh) return Unexpected{mesh.error()};
        const double loaded = wallMillis();
        const AabbTree tree(*mesh);
        best.read = std::min(best.read, loaded - start);
        best.tree = std::min(best.tree, wallMillis() - loaded);
    }
    return best;
}

/// Measures one mesh and adds a row and a point for it.
Expected<LoadTime> addMesh(const std::string& name, int percent, const TriangleMesh& mesh,
                           const std::filesystem::path& file, Experiment& experiment, PlotSeries& series) {
    if (const auto written = writeStl(mesh, file); !written) return Unexpected{written.error()};
    auto time = timeLoading(file);
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    if (!time) return time;
    const auto triangles = static_cast<double>(mesh.triangles.size());
    experiment.rows.push_back({name, static_cast<double>(percent), triangles, time->read, time->tree, time->total()});
    series.points.push_back({triangles, time->total()});
    return time;
}

}  // namespace

Expected<Experiment> measureLoading(TestTeeth& testTeeth, const std::filesystem::path& scratch) {
    Experiment experiment{"table2", "Loading", "", {"tooth", "percent", "triangles", "read_ms", "tree_ms", "total_ms"},
                          {},       1,         {}, {}};
    experiment.method =
        "A binary STL file is read, its vertices are welded and the AABB tree is built: the surface can then be "
        "touched. "
        "Wall time on all cores, the least of five runs.";
    ExperimentPlot panel{"From the file to a surface that can be touched", "triangles", "ms", true, true, {}};
    const std::filesystem::path file = scratch / "table2-scratch.stl";
    PlotSeries bur{"bur", {}, true, false};
    const auto least = addMesh("bur", 100, testTeeth.bur()->mesh(), file, experiment, bur);
    if (!least) return Unexpected{least.error()};
    panel.series.push_back(bur);
    double longest = 0;
    for (const StandardToothKind kind : kStandardTeeth) {
        const auto ladder = testTeeth.ladder(kind);
        if (!ladder) return Unexpected{ladder.error()};
        const std::string name = (*testTeeth.tooth(kind))->name;
        PlotSeries series{name, {}, true, false};
        for (const Resolution& resolution : **ladder) {
            const auto time = addMesh(name, resolution.percent, resolution.mesh, file, experiment, series);
            if (!time) return Unexpected{time.error()};
            longest = std::max(longest, time->total());
        }
        panel.series.push_back(series);
    }
    using namespace published;
    panel.series.push_back({"published", {{kMinTriangles, kShortestLoad}, {kMaxTriangles, kLongestLoad}}, true, true});
    experiment.panels.push_back(panel);
    experiment.comparisons = {
        {"Shortest time to load (288 triangles published, our bur here)", numberText(kShortestLoad) + " ms",
         shortNumber(least->total()) + " ms"},
        {"Longest time to load (325,312 triangles)", numberText(kLongestLoad) + " ms", shortNumber(longest) + " ms"}};
    return experiment;
}

}  // namespace tactooth
