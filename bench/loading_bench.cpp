// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// From an STL file to a surface that can be touched: `loading_bench [RUNS]` times, for 10,000, 325,312 and 2,000,000
// triangles, reading the file into memory, parsing and welding it, building the AABB tree, and, beside that, finding
// out whether it is a solid (`examineSolid`), which has a tree of its own. A row gives the least, the median and the
// largest wall time of RUNS runs (21 unless given), the processor time of all threads together, and a hash of mesh and
// tree, which no change of speed may change unawares.
#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "collision/bvh/aabb_tree.h"
#include "collision/solid/solid.h"
#include "experiments/thread_clock.h"
#include "geometry/files/file_bytes.h"
#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/simplify.h"
#include "geometry/mesh/subdivide.h"
#include "geometry/util/fnv1a.h"
#include "session/io/run_metadata.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

/// Processor time of all threads of this program, ms.
double processMillis() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

enum Stage { kRead, kWeld, kTree, kTotal, kSolid, kStages };
constexpr const char* kStageNames[kStages] = {"read", "parse and weld", "tree", "total", "solid"};

struct StageTimes {
    std::vector<double> wall, processor;  // ms, one a run

    void print(const char* stage, std::size_t triangles) {
        std::ranges::sort(wall);
        std::ranges::sort(processor);
        const std::size_t middle = wall.size() / 2;
        std::printf("| %zu | %s | %.2f | %.2f | %.2f | %.2f | %.2f |\n", triangles, stage, wall.front(), wall[middle],
                    wall.back(), processor.front(), processor[middle]);
    }
};

/// FNV-1a by words.
class Hash {
public:
    void add(std::uint32_t word) { hash_.addWord(word); }
    void add(float number) { add(std::bit_cast<std::uint32_t>(number)); }
    [[nodiscard]] unsigned long long value() const { return hash_.value(); }

private:
    Fnv1a hash_;
};

unsigned long long hashOf(const TriangleMesh& mesh) {
    Hash hash;
    for (const Vec3f& vertex : mesh.vertices) hash.add(vertex.x()), hash.add(vertex.y()), hash.add(vertex.z());
    for (const Triangle& triangle : mesh.triangles) std::ranges::for_each(triangle, [&](auto v) { hash.add(v); });
    return hash.value();
}

void addBelow(const AabbTree& tree, AabbTree::Link link, Hash& hash) {
    if (link.isLeaf()) {
        const AabbTree::Leaf& leaf = tree.leaf(link);
        for (std::uint32_t lane = 0; lane < leaf.count; ++lane) hash.add(leaf.triangle[lane]);
        return;
    }
    const AabbTree::Node& node = tree.node(link);
    for (int i = 0; i < AabbTree::kWidth && node.low[0][i] <= node.high[0][i]; ++i) {
        for (int axis = 0; axis < 3; ++axis) hash.add(node.low[axis][i]), hash.add(node.high[axis][i]);
        addBelow(tree, node.child[i], hash);
    }
}

unsigned long long hashOf(const AabbTree& tree) {
    Hash hash;
    addBelow(tree, tree.rootLink(), hash);
    return hash.value();
}

/// Loads the file `runs` times, after once for the file cache, and prints its rows; false if it cannot be read.
bool timeFile(const std::filesystem::path& file, int runs) {
    StageTimes times[kStages];
    std::size_t triangles = 0;
    unsigned long long meshHash = 0, treeHash = 0;
    for (int run = -1; run < runs; ++run) {
        double wall[kStages + 1] = {wallMillis()};
        double processor[kStages + 1] = {processMillis()};
        const auto mark = [&](int stage) { wall[stage] = wallMillis(), processor[stage] = processMillis(); };
        const auto bytes = readFile(file);
        mark(1);
        const auto mesh = bytes ? parseStl(bytes->bytes(), "tooth") : Expected<TriangleMesh>(Unexpected{bytes.error()});
        mark(2);
        if (!mesh) return std::fprintf(stderr, "%s\n", mesh.error().message().c_str()), false;
        const AabbTree tree(*mesh);
        mark(3);
        const bool isSolid = examineSolid(*mesh).report.isSolid();
        mark(4);
        if (!isSolid) std::fprintf(stderr, "it is no solid\n");
        if (run < 0) {
            triangles = mesh->triangles.size(), meshHash = hashOf(*mesh), treeHash = hashOf(tree);
            continue;
        }
        for (int stage = kRead; stage < kStages; ++stage) {
            const int from = stage == kTotal ? 0 : stage == kSolid ? kTotal : stage;
            const int to = stage == kTotal ? kTotal : stage == kSolid ? kSolid : stage + 1;
            times[stage].wall.push_back(wall[to] - wall[from]);
            times[stage].processor.push_back(processor[to] - processor[from]);
        }
    }
    for (int stage = kRead; stage < kStages; ++stage) times[stage].print(kStageNames[stage], triangles);
    std::printf("| %zu | hashes | mesh %016llx | tree %016llx ||||\n", triangles, meshHash, treeHash);
    std::fflush(stdout);
    return true;
}

TriangleMesh tooth() {
    if (const auto folder = test::realTeethFolder()) {
        if (auto real = readStl(*folder / "microct-meshes/tooth_2_outer.stl")) return std::move(*real);
    }
    std::puts("No real tooth ($TACTOOTH_DATA is not set): a ball takes its place.");
    return test::sphere(Vec3::Zero(), 6, 570, 286);
}

int runBench(int runs) {
    const RunMetadata facts = currentRunMetadata();
    std::printf("%s, %s, commit %s, %s\n%s\n\n", facts.machine.c_str(), facts.compiler.c_str(), facts.commit.c_str(),
                facts.date.c_str(), facts.command.c_str());
    const TriangleMesh whole = tooth();
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "tooth.stl";
    std::puts("| triangles | stage | wall min ms | median | max | processor min ms | median |");
    std::puts("|---:|---|---:|---:|---:|---:|---:|");
    for (const std::size_t count : {std::size_t{10'000}, whole.triangles.size(), std::size_t{2'000'000}}) {
        const TriangleMesh mesh =
            count < whole.triangles.size() ? simplified(whole, count) : subdividedTo(whole, count);
        if (const auto written = writeStl(mesh, file); !written) {
            std::fprintf(stderr, "%s\n", written.error().message().c_str());
            return 1;
        }
        if (!timeFile(file, runs)) return 1;
    }
    return 0;
}

}  // namespace
}  // namespace tactooth

int main(int count, char** words) {
    const int runs = count > 1 ? std::atoi(words[1]) : 21;
    if (runs < 1) return std::fputs("usage: loading_bench [RUNS]\n", stderr), 2;
    return tactooth::runBench(runs);
}
