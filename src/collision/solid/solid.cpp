// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/solid.h"

#include <algorithm>
#include <span>

#include "collision/solid/messages.h"
#include "collision/solid/self_intersection.h"
#include "collision/solid/shells.h"
#include "collision/solid/winding.h"
#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/mesh_specks.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

/// mm: the resolution of a CT of a tooth. Layers as near as this are welded. Coarse surfaces fold by as much.
constexpr double kTolerableOverlap = 0.05;

/// Beside a point of a triangle that is no border between inside and outside: the thickness of the region that two
/// parts share, or that lies outside of all. At a border: 0.
double overlapAt(const SurfacePart& part, std::uint32_t triangle, const Barycentric& place) {
    const int winding = windingInFront(part, triangle, place);
    return winding == 0 ? 0 : clearanceFrom(part, triangle, winding < 0, place);
}

/// Points all over a triangle, up to near its corners.
std::vector<Barycentric> placesOfTriangle() {
    constexpr int kSteps = 8;
    constexpr double kInward = 1e-3;  // a corner itself belongs to other triangles, too
    std::vector<Barycentric> places;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; i + j <= kSteps; ++j) {
            const Barycentric place(i, j, kSteps - i - j);
            places.emplace_back((1 - kInward) / kSteps * place + kInward * kCentroid);
        }
    }
    return places;
}

/// The thickest such region. It is searched at the centroid of each triangle, and all over the triangles that cross
/// others: these may be much larger than the region.
double overlapOf(const SurfacePart& part, std::span<const std::uint32_t> crossing) {
    TACTOOTH_ASSERT(!part.mesh().empty());
    std::vector<double> thickness(part.mesh().triangles.size(), 0);
    parallelFor(
        thickness.size(),
        [&](std::size_t t) { thickness[t] = overlapAt(part, static_cast<std::uint32_t>(t), kCentroid); }, 256);
    constexpr std::size_t kMost = 1024;  // crossing triangles that are sampled: enough, and bounded in time
    const std::vector<Barycentric> places = placesOfTriangle();
    const std::size_t stride = std::max<std::size_t>(1, crossing.size() / kMost);
    parallelFor(
        crossing.size() / stride,
        [&](std::size_t i) {
            const std::uint32_t t = crossing[i * stride];
            for (const Barycentric& place : places) thickness[t] = std::max(thickness[t], overlapAt(part, t, place));
        },
        8);
    return std::min(*std::ranges::max_element(thickness), part.tree().box().diagonal().norm());
}

class SolidExamination {
public:
    SolidExamination(TriangleMesh mesh, const SolidOptions& options) : options_(options) {
        result_.mesh = std::move(mesh);
    }

    ExaminedSolid run() && {
        report().flaw = examine();
        return std::move(result_);
    }

private:
    SolidReport& report() { return result_.report; }
    TriangleMesh& mesh() { return result_.mesh; }

    SolidFlaw examine() {
        report().droppedDuplicates = removeDuplicates(mesh());
        if (edgeBalance(mesh()).odd > 0) report().cracks = weldCracks(mesh());
        if (options_.dropsSpecks) report().droppedSpecks = dropSpecks(mesh());
        if (!hasArea()) return SolidFlaw::Empty;
        report().openEdges = edgeBalance(mesh()).odd;
        if (report().openEdges > 0) return SolidFlaw::Open;
        // Flipping triangles does not change the tree of a surface.
        const SurfacePart part(mesh());
        const auto crossing = selfIntersectingTriangles(part);
        if (!crossing) return SolidFlaw::SelfIntersecting;
        report().selfIntersectingTriangles = crossing->size();
        const ShellOrientation turn = orientShells(part, *crossing, mesh());
        if (turn.isNonOrientable) return SolidFlaw::NonOrientable;
        report().flippedTriangles = turn.flippedTriangles;
        report().shells = turn.shells;
        report().voids = turn.voids;
        TACTOOTH_ASSERT(report().flippedTriangles <= mesh().triangles.size());
        TACTOOTH_ASSERT(report().voids <= report().shells);
        if (!crossing->empty()) {
            report().overlap = overlapOf(turn.flippedTriangles > 0 ? SurfacePart(mesh()) : part, *crossing);
            TACTOOTH_ASSERT(report().overlap >= 0);
            if (report().overlap > kTolerableOverlap) return SolidFlaw::Overlapping;
        }
        return turn.volume > 0 ? SolidFlaw::None : SolidFlaw::Empty;
    }

    [[nodiscard]] bool hasArea() const {
        const TriangleMesh& mesh = result_.mesh;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (mesh.areaVector(t).squaredNorm() > 0) return true;
        }
        return false;
    }

    const SolidOptions& options_;
    ExaminedSolid result_;
};

}  // namespace

ExaminedSolid examineSolid(TriangleMesh mesh, const SolidOptions& options) {
    return SolidExamination(std::move(mesh), options).run();
}

std::vector<ImportNote> notesOn(const SolidReport& report, const Message& what) {
    std::vector<ImportNote> importNotes;
    const auto add = [&](std::size_t count, const MessageText& text, const auto&... values) {
        if (count > 0) importNotes.push_back({ImportNoteTopic::Closedness, {text, what, count, values...}});
    };
    add(report.cracks.moved, msg::kNoteWelded, rounded(report.cracks.tolerance, 6));
    add(report.droppedDuplicates, msg::kNoteDuplicates);
    add(report.droppedSpecks, msg::kNoteSpecks);
    add(report.flippedTriangles, msg::kNoteTurned);
    add(report.flippedTriangles > 0 ? report.voids : 0, msg::kNoteVoids);
    constexpr double kMinReportedOverlap = 0.0005;  // mm: mere touching is not reported
    if (report.isSolid() && report.overlap > kMinReportedOverlap) {
        add(report.selfIntersectingTriangles, msg::kNoteCrossings, rounded(report.overlap, 3));
    }
    return importNotes;
}

Message flawSentence(const SolidReport& report, const Message& what) {
    switch (report.flaw) {
        case SolidFlaw::None:
            break;
        case SolidFlaw::Empty:
            return {msg::kSolidEmpty, what};
        case SolidFlaw::Open:
            return {msg::kSolidOpen, what, report.openEdges};
        case SolidFlaw::NonOrientable:
            return {msg::kSolidTwisted, what};
        case SolidFlaw::Overlapping:
            return {msg::kSolidOverlapping, what, rounded(report.overlap, 2), report.selfIntersectingTriangles};
        case SolidFlaw::SelfIntersecting:
            return {msg::kSolidCrossing, what};
    }
    return {};
}

}  // namespace tactooth
