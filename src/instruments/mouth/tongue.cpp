// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The shape follows textbook drawings: the tongue fills the lower arch, a groove divides its back, and its sides are
// round. It stands as far from the teeth as the finger or the mirror of an assistant holds it away.
#include "instruments/mouth/tongue.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/field/isosurface.h"
#include "geometry/util/parallel_for.h"
#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

class Tongue {
public:
    Tongue(const NeckCurve& lower, std::optional<double> heldAsideAt) : lower_(lower), front_(lower.at(0).neck) {
        if (heldAsideAt) heldAside_ = lower.at(*heldAsideAt);
    }

    [[nodiscard]] double operator()(const Vec3& p) const {
        constexpr double kAside = 8, kRound = 9;          // mm from the necks; radius of the sides
        constexpr double kFloorAside = 2, kFillet = 5.0;  // mm: the floor ends within the gingiva
        const double inside = lower_.insideDistance(p);
        double tongue = smoothIntersection(kAside - inside, p.z() - back(p), kRound);
        if (heldAside_) tongue = smoothIntersection(tongue, -room(p), kRound);
        const double floor = smoothIntersection(kFloorAside - inside, p.z() - ground(p), 1.0);
        const double body = std::max(smoothUnion(tongue, floor, kFillet), below() - p.z());
        constexpr double kRoot = 10;  // mm: it bends down into the throat
        return smoothIntersection(body, end() - p.y(), kRoot);
    }

    /// 0 the floor, 1 the side of the tongue, 2 its back.
    [[nodiscard]] double zone(const Vec3& p) const {
        const double height = back(p), low = ground(p);
        return smoothStep(low + 1.0, low + 3.5, p.z()) + smoothStep(height - 4.5, height - 1.5, p.z());
    }

    [[nodiscard]] Box3 bounds() const {
        const double half = lower_.at(lower_.half()).neck.x();
        return {Vec3(-half, end() - 2, below() - 1), Vec3(half, front_.y(), 8)};
    }

private:
    /// The room that a mirror makes between the tongue and a tooth.
    [[nodiscard]] double room(const Vec3& p) const {
        constexpr double kInside = 6;     // mm from the neck to the middle of the room
        const Vec3 halfAxes(22, 19, 24);  // mm: along the arch, across it, upward
        const Vec3 along = heldAside_->outward.cross(Vec3::UnitZ());
        const Vec3 from = p - (heldAside_->neck - kInside * heldAside_->outward);
        return ellipsoid({from.dot(along), from.dot(heldAside_->outward), from.z()}, halfAxes);
    }
    /// Height of the tongue's back: low behind the incisors, higher toward the throat, with a groove in the middle.
    [[nodiscard]] double back(const Vec3& p) const {
        constexpr double kTip = 3.6, kRise = 6.5;  // mm over the necks at the tip; from there to the highest place
        constexpr double kArch = 0.013;            // 1/mm: across
        const double depth = front_.y() - p.y();
        const double groove = 1.3 * bump(p.x(), 1.7) * smoothStep(9, 18, depth) * smoothStep(60, 48, depth);
        const double hollow = 0.9 * bump(p.x(), 7) * smoothStep(10, 22, depth) * smoothStep(56, 40, depth);
        const double arched = kArch * p.x() * p.x();
        return front_.z() + kTip + kRise * smoothStep(14, 46, depth) - groove - hollow - arched;
    }
    /// Height of the floor of the mouth. In the middle the lingual frenulum runs from the tongue to the jaw.
    [[nodiscard]] double ground(const Vec3& p) const {
        constexpr double kDeep = 6.5;  // mm below the necks
        const double depth = front_.y() - p.y();
        return front_.z() - kDeep + 2.4 * bump(p.x(), 1.2) * smoothStep(2, 5, depth) * smoothStep(16, 8, depth);
    }
    [[nodiscard]] double below() const { return front_.z() - 11; }
    [[nodiscard]] double end() const { return lower_.at(lower_.half()).neck.y() - 20; }

    const NeckCurve& lower_;
    Vec3 front_;
    std::optional<NeckCurve::Place> heldAside_;
};

}  // namespace

ZonedMesh makeTongue(const NeckCurve& lower, std::optional<double> heldAsideAt) {
    constexpr double kCell = 0.9;  // mm
    const Tongue tongue(lower, heldAsideAt);
    ZonedMesh shown;
    shown.mesh = isosurface(tongue, tongue.bounds(), {.cellSize = kCell});
    shown.zones.resize(shown.mesh.vertices.size());
    parallelFor(shown.zones.size(), [&](std::size_t i) {
        shown.zones[i] = ZonedMesh::zoneOf(tongue.zone(shown.mesh.vertices[i].cast<double>()));
    });
    return shown;
}

}  // namespace tactooth
