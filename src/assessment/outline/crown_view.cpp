// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/outline/crown_view.h"

#include <utility>

#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kContact = 0.15;  // mm: what is so near to the farthest point is the contact area

}  // namespace

CrownView::CrownView(std::shared_ptr<const SurfacePart> outer) : surface_{.base = std::move(outer)} {
    for (const Vec3f& vertex : vertices()) {
        if (vertex.z() > 0) box_.extend(vertex.cast<double>());
    }
}

double CrownView::heightAt(double x, double y) const {
    const auto hit = firstHit(surface_, {Vec3(x, y, kFarAway), -Vec3::UnitZ()});
    return hit ? kFarAway - *hit : -kFarAway;
}

Vec3 CrownView::contact(double towardX) const {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    const double farthest = outside(towardX);
    for (const Vec3f& vertex : vertices()) {
        if (vertex.z() <= 0 || towardX * vertex.x() < farthest - kContact) continue;
        sum += vertex.cast<double>();
        ++count;
    }
    return sum / count;
}

double CrownView::outsideAt(double towardX, double y, double z) const {
    const auto hit = firstHit(surface_, {Vec3(towardX * kFarAway, y, z), -towardX * Vec3::UnitX()});
    return hit ? kFarAway - *hit : outside(towardX);
}

}  // namespace tactooth
