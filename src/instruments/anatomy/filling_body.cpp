// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/filling_body.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"
#include "instruments/anatomy/lesion.h"

namespace tactooth {
namespace {

constexpr double kRounded = 0.2;  // mm: radius of the angles between floor and walls, as a pear leaves them

}  // namespace

ScalarField fillingBody(const ToothShape& shape, const Filling& filling) {
    TACTOOTH_ASSERT(filling.width > 0 && filling.depth > 0);
    const LesionOrigin place = lesionOrigin(shape, filling.site);
    // Along the fissure and the gum: mesiodistal, but on a proximal side buccolingual.
    const Vec3 wanted = std::abs(place.inward.x()) > 0.7 ? Vec3::UnitY() : Vec3::UnitX();
    const Vec3 along = (wanted - wanted.dot(place.inward) * place.inward).normalized();
    const double width = filling.width, depth = filling.depth;
    const double rounded = std::min({kRounded, width / 4, depth / 4});
    return [=](const Vec3& point) {
        const Vec3 from = point - place.site;
        const double deep = from.dot(place.inward);
        const Vec3 level = from - deep * place.inward;
        const double lengthwise = level.dot(along);
        const Vec3 end = std::clamp(lengthwise, -width / 2, width / 2) * along;
        const double aside = (level - end).norm() - width / 2 + rounded, below = deep - depth + rounded;
        const double inner = std::min(std::max(aside, below), 0.0);
        return inner + std::hypot(std::max(aside, 0.0), std::max(below, 0.0)) - rounded;
    };
}

}  // namespace tactooth
