// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/draft_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/gui/scene/surface_line.h"
#include "assessment/outline/crown_view.h"
#include "assessment/outline/outline_paths.h"
#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

using Kind = OutlineMarks::Kind;

constexpr int kCircle = 32;        // corners
constexpr double kOverEdge = 0.1;  // mm that the mark of a box stays inside the crown

OutlineMarks::Line boxMark(const PreparationPlan& plan, const ProximalBox& box, double middle,
                           const std::shared_ptr<const SurfacePart>& outer) {
    const double outside = CrownView(outer).outside(box.towardX);
    const double wall = box.towardX * (outside - box.axialDepth), end = box.towardX * (outside - kOverEdge);
    const double half = box.width / 2;
    const double z = outlineReference(plan, *outer).value_or(Vec3::Zero()).z();
    const std::vector<Vec3> corners = {
        {wall, middle - half, z}, {end, middle - half, z}, {end, middle + half, z}, {wall, middle + half, z}};
    return {.kind = Kind::Box, .places = lineOnSurface(corners, plan.outward, true, outer), .outward = plan.outward};
}

/// A circle as wide as the decay, on the surface.
OutlineMarks::Line decayMark(const Vec3& place, double width, const SurfacePart& outer) {
    const auto nearest = closestPoint(outer, place);
    const Triangle& t = outer.mesh().triangles[nearest->triangle];
    const auto corner = [&](std::size_t i) { return outer.mesh().vertices[t[i]].cast<double>(); };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    OutlineMarks::Line mark{.kind = Kind::Decay, .places = {}, .outward = normal, .handles = {nearest->point}};
    for (int i = 0; i <= kCircle; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCircle;
        mark.places.emplace_back(nearest->point + width / 2 * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return mark;
}

}  // namespace

OutlineMarks marksOf(const ExerciseDraft& draft, const std::shared_ptr<const SurfacePart>& outer,
                     const std::optional<DraftPoint>& held) {
    OutlineMarks marks;
    for (const DraftLine& line : draft.lines()) {
        const std::vector<Vec3>& points = draft.points(line);
        const bool isClosed = draft.openLine() != line && points.size() > 2;
        const Vec3 outward = draft.outwardOf(line);
        marks.lines.push_back({.kind = line.isCavity() ? Kind::Cavity : Kind::Forbidden,
                               .places = lineOnSurface(points, outward, isClosed, outer),
                               .outward = outward,
                               .handles = points});
        if (held && held->line == line) marks.lines.back().held = held->point;
    }
    const PreparationPlan* plan = draft.plan();
    if (plan != nullptr && plan->outline && plan->outline->corners.size() > 2) {
        for (const ProximalBox& box : plan->boxes) {
            const auto middle = boxMiddle(*plan, box, CrownView(outer).outside(box.towardX));
            if (middle) marks.lines.push_back(boxMark(*plan, box, *middle, outer));
        }
    }
    for (const Vec3& place : draft.decay())
        marks.lines.push_back(decayMark(place, std::get<ToothRequest>(draft.exercise().tooth).lesion->width, *outer));
    return marks;
}

}  // namespace tactooth
