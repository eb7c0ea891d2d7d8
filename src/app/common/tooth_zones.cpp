// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Zones of a lesion in dentin, from the outside in: infected, affected, sclerotic (T. Fusayama, Two layers of carious
// dentin, Oper. Dent. 4, 1979). Their widths here were chosen for pictures.
#include "app/common/tooth_zones.h"

#include <algorithm>
#include <cmath>

#include "collision/bvh/closest_point.h"
#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

/// The zones' appearances, in the order of zoneAppearances.
enum Zone : SurfaceTag { kThin, kIncisal, kWhiteSpot, kCutEnamel, kCutDentin, kSclerotic, kLeathery };

constexpr double kThinnest = 0.1, kFull = 1.0;        // mm of enamel: here dentin shines through most, here not at all
constexpr double kThick = 1.5, kBare = 2.4;           // mm of enamel: from here on it is grey, most here
constexpr double kWhiteSpotReach = 0.9;               // mm of enamel around a lesion
constexpr double kScleroticReach = 0.9;               // mm of dentin around a lesion
constexpr double kSoftened = 0.08, kInfected = 0.55;  // mm inside a lesion: leathery up to here, soft from here on

using Parts = std::vector<std::shared_ptr<const SurfacePart>>;

/// Distance to the nearest of `parts`, `within` if they are farther away.
double distanceTo(const Parts& parts, const Vec3& point, double within) {
    double nearest = within;
    for (const auto& part : parts) {
        if (part->tree().box().squaredExteriorDistance(point) > nearest * nearest) continue;
        if (const auto found = closestPoint(*part, point, nearest)) nearest = std::min(nearest, found->distance);
    }
    return nearest;
}

class ToothZones : public AppearanceZones {
public:
    ToothZones(const LayeredTooth& tooth, std::size_t firstZone) : firstZone_(firstZone) {
        for (const MaterialId id : tooth.materials().ids()) tissues_.push_back(tissueOf(tooth.materials(), id));
        for (const LayeredTooth::Layer& layer : tooth.layers()) {
            const Tissue tissue = tissues_[static_cast<std::size_t>(layer.material)];
            if (tissue == Tissue::Dentin) dentin_.push_back(layer.part);
            if (tissue == Tissue::Decay) decay_.push_back(layer.part);
        }
    }

    [[nodiscard]] AppearanceMix at(const Place& place) const override {
        switch (place.tag < tissues_.size() ? tissues_[place.tag] : Tissue::Other) {
            case Tissue::Enamel:
                return enamelAt(place);
            case Tissue::Dentin:
                return dentinAt(place);
            case Tissue::Decay:
                return decayAt(place);
            case Tissue::Other:
                break;
        }
        return {place.tag, place.tag, 0};
    }

private:
    enum class Tissue : std::uint8_t { Enamel, Dentin, Decay, Other };

    static Tissue tissueOf(const MaterialRegistry& materials, MaterialId id) {
        if (materials.hasRole(id, MaterialRole::Enamel)) return Tissue::Enamel;
        if (materials.hasRole(id, MaterialRole::Dentin)) return Tissue::Dentin;
        return materials.hasRole(id, MaterialRole::Decay) ? Tissue::Decay : Tissue::Other;
    }
    [[nodiscard]] SurfaceTag zone(Zone of) const { return static_cast<SurfaceTag>(firstZone_ + of); }
    [[nodiscard]] static AppearanceMix mix(SurfaceTag first, SurfaceTag second, double share) {
        return {first, second, static_cast<std::uint8_t>(std::lround(255 * share))};
    }

    [[nodiscard]] AppearanceMix enamelAt(const Place& place) const {
        const SurfaceTag sound = place.isCut ? zone(kCutEnamel) : place.tag;
        const double toDecay = distanceTo(decay_, place.point, kWhiteSpotReach);
        if (toDecay < kWhiteSpotReach) {
            return mix(sound, zone(kWhiteSpot), smoothStep(kWhiteSpotReach, kSoftened, toDecay));
        }
        if (place.isCut || dentin_.empty()) return {sound, sound, 0};
        const double thickness = distanceTo(dentin_, place.point, kBare);
        if (thickness < kFull) return mix(sound, zone(kThin), smoothStep(kFull, kThinnest, thickness));
        return mix(sound, zone(kIncisal), 0.7 * smoothStep(kThick, kBare, thickness));
    }

    [[nodiscard]] AppearanceMix dentinAt(const Place& place) const {
        const SurfaceTag sound = place.isCut ? zone(kCutDentin) : place.tag;
        const double toDecay = distanceTo(decay_, place.point, kScleroticReach);
        return mix(sound, zone(kSclerotic), smoothStep(kScleroticReach, 0, toDecay));
    }

    [[nodiscard]] AppearanceMix decayAt(const Place& place) const {
        if (!place.isCut) return {place.tag, place.tag, 0};
        return mix(place.tag, zone(kLeathery),
                   smoothStep(kInfected, kSoftened, distanceTo(decay_, place.point, kInfected)));
    }

    std::vector<Tissue> tissues_;  // by tag: a picture may outlive the tooth and its materials
    std::size_t firstZone_;
    Parts dentin_, decay_;
};

}  // namespace

std::shared_ptr<const AppearanceZones> toothZones(const LayeredTooth& tooth, const MaterialTable& materials) {
    return std::make_shared<const ToothZones>(tooth, materials.registry().size());
}

std::vector<ZoneAppearance> zoneAppearances(const MaterialRegistry& materials) {
    const MaterialId enamel = materials.withRole(MaterialRole::Enamel);
    const MaterialId dentin = materials.withRole(MaterialRole::Dentin);
    return {{appearances::thinEnamel(), enamel},
            {appearances::incisalEnamel(), enamel},
            {appearances::whiteSpot(), enamel},
            {appearances::cutEnamel(), enamel},
            {appearances::cutDentin(), dentin},
            {appearances::scleroticDentin(), dentin},
            {appearances::affectedDentin(), materials.withRole(MaterialRole::Decay)}};
}

}  // namespace tactooth
