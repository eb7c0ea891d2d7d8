// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/lesion.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/util/assert.h"
#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

constexpr double kStep = 0.02;  // mm, of a search along a line

/// The middle of the tooth between its buccal and lingual side at a height.
Vec3 middleAt(const ToothShape& shape, double z) {
    double sum = 0;
    int inside = 0;
    for (double y = shape.bounds.min().y(); y < shape.bounds.max().y(); y += kStep) {
        if (shape.outer(Vec3(0, y, z)) >= 0) continue;
        sum += y;
        ++inside;
    }
    return {0, inside > 0 ? sum / inside : 0, z};
}

double crownHeight(const ToothShape& shape) {
    double z = shape.bounds.max().z();
    while (z > 0 && shape.outer(middleAt(shape, z)) >= 0) z -= 0.1;
    return z;
}

LesionOrigin placeAlong(const ToothShape& shape, const Vec3& from, const Vec3& outward) {
    LesionOrigin place;
    place.inward = -outward;
    double distance = 0;
    while (shape.outer(from + distance * outward) < 0) distance += kStep;
    place.site = from + distance * outward;
    double enamel = 0;
    while (enamel < distance && shape.core(place.site - enamel * outward) >= 0) enamel += kStep;
    place.enamel = enamel;
    return place;
}

/// Out of the tooth, not normalised.
Vec3 gradientAt(const ToothShape& shape, const Vec3& place) {
    Vec3 gradient;
    for (int i = 0; i < 3; ++i) {
        const Vec3 step = kStep * Vec3::Unit(i);
        gradient[i] = (shape.outer(place + step) - shape.outer(place - step)) / (2 * kStep);
    }
    return gradient;
}

/// The nearest place of the surface, by Newton's method along the gradient.
LesionOrigin nearestTo(const ToothShape& shape, const Vec3& place) {
    constexpr int kSteps = 30;         // a place on the mesh of the tooth needs two or three
    constexpr double kThickest = 4.0;  // mm: more than any enamel
    LesionOrigin origin{.site = place, .inward = -Vec3::UnitZ(), .enamel = 0};
    for (int i = 0; i < kSteps; ++i) {
        const Vec3 gradient = gradientAt(shape, origin.site);
        if (!(gradient.squaredNorm() > 0)) break;
        origin.inward = -gradient.normalized();
        origin.site -= shape.outer(origin.site) / gradient.squaredNorm() * gradient;
    }
    while (origin.enamel < kThickest && shape.core(origin.site + origin.enamel * origin.inward) >= 0)
        origin.enamel += kStep;
    return origin;
}

/// From the frame of the tooth into that of its shape, where +x is mesial for every tooth.
Vec3 inShape(const ToothShape& shape, const Vec3& place) {
    return {mesialX(shape.fdi) * place.x(), place.y(), place.z()};
}

}  // namespace

LesionOrigin lesionOrigin(const ToothShape& shape, LesionSite site) {
    constexpr double kContact = 0.60;  // share of the crown's height: just below the contact, where plaque stays
    constexpr double kNeck = 1.4;      // mm above the cervical line
    const double contact = kContact * crownHeight(shape);
    switch (site) {
        case LesionSite::Usual:
        case LesionSite::Occlusal:
            break;
        case LesionSite::Mesial:
            return placeAlong(shape, middleAt(shape, contact), Vec3::UnitX());
        case LesionSite::Distal:
            return placeAlong(shape, middleAt(shape, contact), -Vec3::UnitX());
        case LesionSite::Buccal:
            return placeAlong(shape, Vec3(0, 0, kNeck), Vec3::UnitY());
        case LesionSite::Lingual:
            return placeAlong(shape, Vec3(0, 0, kNeck), -Vec3::UnitY());
    }
    return {shape.lesionSite, shape.lesionInward, shape.lesionEnamel};
}

namespace {

/// Decay that begins at one place, larger by `beyond` on all sides, mm.
class SingleLesion {
public:
    SingleLesion(const LesionOrigin& origin, const Lesion& lesion, double beyond)
        : origin_(origin), width_(lesion.width), beyond_(beyond) {
        middle_ = 0.10 * width_, half_ = 0.36 * width_;
        throat_ = origin.enamel;
        if (lesion.depth) {
            const double inDentin = std::max(0.0, *lesion.depth - origin.enamel);
            middle_ *= inDentin / (0.46 * width_);
            half_ *= inDentin / (0.46 * width_);
            throat_ = std::min(throat_, *lesion.depth - 0.34 * width_);  // the end of the throat is round
        }
        reach_ = 0.5 + width_ + beyond + std::max(throat_, origin.enamel + middle_ + half_);
    }

    [[nodiscard]] double operator()(const Vec3& point) const {
        const Vec3 from = point - origin_.site;
        const double deep = from.dot(origin_.inward), aside = (from - deep * origin_.inward).norm();
        // Decay protrudes from the tooth, so that its mouth is open; a rim lies around what is within the tooth.
        const double top = beyond_ > 0 ? -0.01 : -0.5;
        const double mouth = taperedCapsule(Vec3(aside, 0, deep), Vec3(0, 0, top), 0.22 * width_ + beyond_,
                                            Vec3(0, 0, std::max(throat_, 0.0)), 0.34 * width_ + beyond_);
        constexpr double kThinnest = 0.05;  // mm; a smaller lesion stays in the enamel
        if (half_ < kThinnest) return mouth;
        const Vec3 spread(0.5 * width_ + beyond_, 0.5 * width_ + beyond_, half_ + beyond_);
        const double body = ellipsoid(Vec3(aside, 0, deep - origin_.enamel - middle_), spread);
        return smoothUnion(mouth, body, 0.15 * width_);
    }

    /// No less than this: quick.
    [[nodiscard]] double atLeast(const Vec3& point) const { return (point - origin_.site).norm() - reach_; }

private:
    LesionOrigin origin_;
    double width_;
    double beyond_;
    double middle_;  // mm: of the part in the dentin, below the enamel
    double half_;    // mm: its half height
    double throat_;  // mm: length of the part in the enamel
    double reach_;   // mm: no point of it is farther from the site
};

ScalarField bodyOf(const ToothShape& shape, const Lesion& lesion, double beyond) {
    TACTOOTH_ASSERT(lesion.width > 0 && lesion.width <= kMaxLesionWidth);
    TACTOOTH_ASSERT(!lesion.depth || *lesion.depth > 0);
    TACTOOTH_ASSERT(lesion.place || lesion.spread.empty());
    const LesionOrigin first =
        lesion.place ? nearestTo(shape, inShape(shape, *lesion.place)) : lesionOrigin(shape, lesion.site);
    std::vector<SingleLesion> parts = {SingleLesion(first, lesion, beyond)};
    for (const Vec3& place : lesion.spread) parts.emplace_back(nearestTo(shape, inShape(shape, place)), lesion, beyond);
    const double fillet = 0.15 * lesion.width;
    return [parts = std::move(parts), fillet](const Vec3& point) {
        double value = parts.front()(point);
        for (std::size_t i = 1; i < parts.size(); ++i) {
            // A part that is farther by the fillet changes nothing.
            if (parts[i].atLeast(point) < value + fillet) value = smoothUnion(value, parts[i](point), fillet);
        }
        return value;
    };
}

}  // namespace

ScalarField lesionBody(const ToothShape& shape, const Lesion& lesion) { return bodyOf(shape, lesion, 0); }

ScalarField lesionRimBody(const ToothShape& shape, const Lesion& lesion) {
    TACTOOTH_ASSERT(lesion.rim && lesion.rim->width > 0 && lesion.rim->width <= kMaxRimWidth);
    return [core = shape.core, body = bodyOf(shape, lesion, lesion.rim->width)](const Vec3& point) {
        return std::max(core(point), body(point));
    };
}

}  // namespace tactooth
