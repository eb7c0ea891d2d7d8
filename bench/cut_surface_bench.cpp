// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// What a walk over a heavily cut tooth saves by the tree from which the cut triangles were taken: a bur of 1.2 mm cuts
// parallel slots 2.5 mm deep into a tooth of some 325,000 triangles. Then, at 400 places of the bur in its slots, a
// walk looks for the tooth's own triangles near it: over the whole tree, asking the mask about each triangle ("mask"),
// and over the masked BVH. Both must find the same ones. Times are the thread's processor time, the least of nine
// runs.
#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "experiments/thread_clock.h"
#include "milling.h"
#include "session/io/run_metadata.h"
#include "tooth/surface/incremental_surface.h"

namespace tactooth {
namespace {

constexpr int kMoves = 400;
constexpr double kStep = 0.1;  // mm a move
constexpr int kRuns = 9;
constexpr double kFirstX = -2;  // mm from the tooth's middle
const Box3 kBur(Vec3(-0.6, -0.6, 0), Vec3(0.6, 0.6, 4.2));

struct Found {
    std::size_t nodes = 0, leaves = 0, triangles = 0;
};

bool meets(const Box3& box, const Box3& other) { return !box.intersection(other).isEmpty(); }

/// Counts what a walk comes past on its way to the visible triangles whose boxes meet `box`.
Found walk(const VisibleBase& base, const Box3& box) {
    Found found;
    std::array<AabbTree::Link, AabbTree::kStackSize> stack;
    int size = 0;
    stack[size++] = base.tree.rootLink();
    while (size > 0) {
        const AabbTree::Link link = stack[--size];
        if (!link.isLeaf()) {
            ++found.nodes;
            const AabbTree::Node& node = base.tree.node(link);
            for (int i = 0; i < AabbTree::kWidth && node.low[0][i] <= node.high[0][i]; ++i) {
                const Box3 child(Vec3(node.low[0][i], node.low[1][i], node.low[2][i]),
                                 Vec3(node.high[0][i], node.high[1][i], node.high[2][i]));
                if (meets(box, child)) stack[size++] = node.child[i];
            }
            continue;
        }
        ++found.leaves;
        const AabbTree::Leaf& leaf = base.tree.leaf(link);
        for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
            if (base.hidden != nullptr && isHidden(*base.hidden, leaf.triangle[lane])) continue;
            Box3 triangle;
            for (const auto& corner : leaf.corner)
                triangle.extend(Vec3(corner[0][lane], corner[1][lane], corner[2][lane]));
            found.triangles += meets(box, triangle) ? 1 : 0;
        }
    }
    return found;
}

/// Prints one row: the means over all poses.
std::size_t timeWalks(const char* way, double reach, const VisibleBase& base, const Box3& tooth) {
    Found sum;
    double micros = 0;
    for (int i = 0; i < kMoves; ++i) {
        const Vec3 tip = poseAlongPath(tooth, i * kStep, kFirstX).position;
        const Box3 box(kBur.min() + tip - Vec3::Constant(reach), kBur.max() + tip + Vec3::Constant(reach));
        double least = std::numeric_limits<double>::infinity();
        Found found;
        for (int run = 0; run < kRuns; ++run) {
            const double start = threadMicros();
            found = walk(base, box);
            least = std::min(least, threadMicros() - start);
        }
        micros += least;
        sum.nodes += found.nodes, sum.leaves += found.leaves, sum.triangles += found.triangles;
    }
    std::printf("| %.2f | %s | %.1f | %.1f | %.1f | %.2f |\n", reach, way, static_cast<double>(sum.nodes) / kMoves,
                static_cast<double>(sum.leaves) / kMoves, static_cast<double>(sum.triangles) / kMoves, micros / kMoves);
    return sum.triangles;
}

/// The time to make the masked BVH: its preparation once for each tooth, the tree once for each cut.
void timeMasking(const Surface& surface) {
    const AabbTree& whole = surface.base->tree();
    const double start = wallMillis();
    MaskedBvh masked(whole);
    const double ready = wallMillis();
    for (std::uint32_t t = 0; t < surface.base->mesh().triangles.size(); ++t)
        if (isHidden(*surface.hidden, t)) masked.setHidden(t, true);
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < kRuns; ++run) {
        const double begin = threadMicros();
        const AabbTree tree = masked.maskedTree();
        least = std::min(least, threadMicros() - begin);
    }
    std::printf("Masked BVH prepared in %.2f ms; a masked tree in %.0f us, %zu KB of its own beside %zu KB shared.\n\n",
                ready - start, least, (surface.maskedTree->bytes() - whole.bytes()) / 1024, whole.bytes() / 1024);
}

int runBench(double voxel) {
    const RunMetadata facts = currentRunMetadata();
    std::printf("%s, %s, commit %s, %s\n%s\n\n", facts.machine.c_str(), facts.compiler.c_str(), facts.commit.c_str(),
                facts.date.c_str(), facts.command.c_str());
    const auto tooth = std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(largeTooth())));
    const RevolutionEnvelope bur = *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.6, 4.2, 96));
    CutVolume volume(tooth, voxel);
    IncrementalSurface live(volume);
    const Box3 box = tooth->outer()->tree().box();
    for (int i = 0; i < kMoves; ++i) {
        const CarveResult result =
            volume.carve(bur, poseAlongPath(box, i * kStep, kFirstX), poseAlongPath(box, (i + 1) * kStep, kFirstX));
        live.update(volume, result.changed);
    }
    const Surface& surface = *live.snapshot();
    std::size_t hidden = 0;
    for (std::uint32_t t = 0; t < surface.base->mesh().triangles.size(); ++t) hidden += isHidden(*surface.hidden, t);
    std::printf("%zu patches, %zu of %zu triangles cut. ", surface.patches.size(), hidden,
                surface.base->mesh().triangles.size());
    timeMasking(surface);
    std::puts("| reach mm | walk | nodes | leaves | triangles found | us |\n|---:|---|---:|---:|---:|---:|");
    for (const double reach : {0.0, 0.02, 0.1, 0.3}) {
        const VisibleBase masked{surface.base->tree(), surface.hidden.get()};
        if (timeWalks("mask", reach, masked, box) != timeWalks("thinned", reach, visibleBase(surface), box)) {
            std::fputs("The two trees hold different triangles.\n", stderr);
            return 1;
        }
    }
    return 0;
}

}  // namespace
}  // namespace tactooth

int main() {
    constexpr double kVoxel = 0.05;  // mm
    return tactooth::runBench(kVoxel);
}
