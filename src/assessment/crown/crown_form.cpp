// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/crown_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "assessment/crown/face_part.h"
#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

constexpr double kOverLine = 1.0;   // mm above the finish line, from which on the walls follow the uncut surface
constexpr double kEdgeStep = 0.25;  // mm between two heights of an incisal edge
constexpr double kEdgeReach = 0.8;  // mm to both sides, over which an edge is evened out
constexpr double kAround = 0.3;     // mm around the tooth
constexpr int kSmoothings = 10;     // of the direction of the surface, where its buccal and lingual faces meet

/// The mean of each vertex and its neighbours, those of large triangles counting more.
void smooth(const TriangleMesh& mesh, std::vector<double>& values) {
    std::vector<double> sums(values.size()), weights(values.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.triangles[i];
        const double area = mesh.areaVector(i).norm();
        const double mean = (values[a] + values[b] + values[c]) / 3;
        for (const std::uint32_t vertex : mesh.triangles[i]) {
            sums[vertex] += area * mean;
            weights[vertex] += area;
        }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (weights[i] > 0) values[i] = sums[i] / weights[i];
    }
}

/// How far the surface faces to buccal at each vertex: 1 if it does, -1 to lingual. Smoothed, so that the line between
/// both does not follow single triangles.
std::vector<double> facingBuccal(const TriangleMesh& mesh, const Vec3& buccal) {
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const std::uint32_t vertex : mesh.triangles[i]) normals[vertex] += mesh.areaVector(i);
    }
    std::vector<double> facing;
    facing.reserve(normals.size());
    for (const Vec3& normal : normals) facing.push_back(buccal.dot(normal.normalized()));
    for (int i = 0; i < kSmoothings; ++i) smooth(mesh, facing);
    return facing;
}

}  // namespace

CrownForm::CrownForm(const PreparationPlan& plan, FinishLine line, std::shared_ptr<const SurfacePart> outer)
    : line_(std::move(line)), walls_(*plan.crown, line_), outer_(std::move(outer)), rounding_(plan.crown->rounding) {
    findAxialFaces(*plan.crown);
    if (plan.crown->isIncisal)
        findEdge(*plan.crown);
    else
        occlusal_.emplace(*plan.crown, line_, outer_);
}

Expected<CrownForm> CrownForm::make(const PreparationPlan& plan, const LayeredTooth& tooth,
                                    std::shared_ptr<const SurfacePart> outer) {
    Expected<FinishLine> line = FinishLine::on(plan, tooth, outer);
    if (!line) return Unexpected{line.error()};
    return CrownForm(plan, std::move(*line), std::move(outer));
}

/// Where one side is widest, mm above the finish line. Below it the surface leans outwards: a wall that followed it
/// would be an undercut. `side`: 1: buccal, -1: lingual.
double CrownForm::girthAbove(double side) const {
    double widest = -std::numeric_limits<double>::infinity(), above = 0;
    for (const Vec3f& vertex : outer_->mesh().vertices) {
        const Vec3 place = vertex.cast<double>();
        const double out = side * line_.aside().dot(place);
        if (out <= widest || line_.axis().dot(place) < line_.lowest()) continue;
        widest = out;
        above = line_.placeOf(place).above;
    }
    return above;
}

void CrownForm::findAxialFaces(const CrownOutline& crown) {
    const TriangleMesh& mesh = outer_->mesh();
    std::vector<double> facing = facingBuccal(mesh, line_.aside());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 centre = (mesh.corner(i, 0) + mesh.corner(i, 1) + mesh.corner(i, 2)) / 3;
        if (line_.axis().dot(centre) < line_.lowest() - kAround) continue;
        for (int corner = 0; corner < 3; ++corner) box_.extend(mesh.corner(i, corner));
    }
    box_ = Box3(box_.min() - Vec3::Constant(kAround), box_.max() + Vec3::Constant(kAround));
    const auto add = [&](double side, double depth) {
        TriangleMesh faces = aboveLine(partAbove(mesh, facing), std::max(kOverLine, girthAbove(side)));
        if (!faces.triangles.empty()) sides_.push_back({std::make_shared<const SurfacePart>(std::move(faces)), depth});
    };
    add(1, crown.buccal);
    for (double& toBuccal : facing) toBuccal = -toBuccal;
    add(-1, crown.lingual);
}

/// The part of the faces that lies more than this above the finish line, mm.
TriangleMesh CrownForm::aboveLine(const TriangleMesh& faces, double least) const {
    std::vector<double> above;
    above.reserve(faces.vertices.size());
    for (const Vec3f& vertex : faces.vertices) {
        const Vec3 place = vertex.cast<double>();
        const bool isNear = line_.axis().dot(place) > line_.lowest();
        above.push_back(isNear ? line_.placeOf(place).above - least : -least);
    }
    return partAbove(faces, above);
}

/// The incisal edge as seen from the cheek, evened out, lowered by the reduction.
void CrownForm::findEdge(const CrownOutline& crown) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3f& vertex : outer_->mesh().vertices) {
        if (line_.axis().dot(vertex.cast<double>()) < line_.lowest()) continue;
        low = std::min(low, line_.across().dot(vertex.cast<double>()));
        high = std::max(high, line_.across().dot(vertex.cast<double>()));
    }
    endsFrom_ = low;
    const auto count = static_cast<std::size_t>(std::ceil((high - low) / kEdgeStep)) + 1;
    std::vector<double> edge(count, line_.lowest());
    for (const Vec3f& vertex : outer_->mesh().vertices) {
        const double along = (line_.across().dot(vertex.cast<double>()) - low) / kEdgeStep;
        if (along < 0 || along > static_cast<double>(count - 1)) continue;
        double& top = edge[static_cast<std::size_t>(std::lround(along))];
        top = std::max(top, line_.axis().dot(vertex.cast<double>()));
    }
    const int reach = static_cast<int>(std::lround(kEdgeReach / kEdgeStep));
    for (int i = 0; i < static_cast<int>(count); ++i) {
        double sum = 0;
        int places = 0;
        for (int k = std::max(0, i - reach); k <= std::min(static_cast<int>(count) - 1, i + reach); ++k) {
            sum += edge[static_cast<std::size_t>(k)];
            ++places;
        }
        ends_.push_back(sum / places - crown.occlusal);
    }
}

RemovedBody::Depth CrownForm::belowEdge(const Vec3& place) const {
    const double last = static_cast<double>(ends_.size() - 1);
    const double along = std::clamp((line_.across().dot(place) - endsFrom_) / kEdgeStep, 0.0, last - 1e-9);
    const auto at = static_cast<std::size_t>(along);
    const double rise = ends_[at + 1] - ends_[at];
    const double end = ends_[at] + (along - static_cast<double>(at)) * rise;
    const Vec3 gradient = line_.axis() - rise / kEdgeStep * line_.across();
    return {(line_.axis().dot(place) - end) / gradient.norm(), gradient.normalized()};
}

RemovedBody::Depth CrownForm::depthAt(const Vec3& place) const {
    const FinishLine::Place at = line_.placeOf(place);
    const Depth aboveLine{at.above / at.upward.norm(), at.upward.normalized()};
    if (aboveLine.value <= -1) return aboveLine;
    Depth deepest = walls_.outside(place, at);
    constexpr double kEnough = 0.7;  // mm: all that anybody asks
    for (const Side& side : sides_) {
        const double wanted = side.depth - std::max(deepest.value - rounding_, -kEnough);
        if (wanted <= 0 || deepest.value >= kEnough) continue;
        if (const auto near = closestPoint(*side.faces, place, wanted)) {
            const Vec3 to = near->point - place;
            const Vec3 gradient = to.norm() > 1e-9 ? Vec3(to.normalized()) : line_.axis();
            deepest = unitedRound(deepest, {side.depth - near->distance, gradient}, rounding_);
        }
    }
    if (occlusal_) deepest = unitedRound(deepest, occlusal_->over(place), rounding_);
    if (!ends_.empty()) deepest = unitedRound(deepest, belowEdge(place), rounding_);
    return deepest.value < aboveLine.value ? deepest : aboveLine;
}

}  // namespace tactooth
