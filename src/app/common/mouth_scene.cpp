// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/mouth_scene.h"

#include <algorithm>
#include <cmath>

#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

/// Teeth in the mouth are wet, and slightly yellower than cut enamel.
Appearance toothAppearance() {
    Appearance appearance = appearances::enamel();
    appearance.wetness = std::max(appearance.wetness, 0.7F);
    return appearance;
}

/// The zones of a soft tissue, vertex by vertex.
class TissueZones : public AppearanceZones {
public:
    using Zones = std::shared_ptr<const std::vector<std::uint8_t>>;
    explicit TissueZones(Zones zones) : zones_(std::move(zones)) {}
    [[nodiscard]] AppearanceMix at(const Place& place) const override {
        constexpr std::uint8_t kHalf = ZonedMesh::kSecond;
        const std::uint8_t zone = (*zones_)[place.vertex];
        const bool isBeyond = zone > kHalf;
        const int share = std::min(255, 255 * (isBeyond ? zone - kHalf : zone) / kHalf);
        return isBeyond ? AppearanceMix{kMiddle, kLast, static_cast<std::uint8_t>(share)}
                        : AppearanceMix{kFirst, kMiddle, static_cast<std::uint8_t>(share)};
    }

private:
    static constexpr SurfaceTag kFirst = 0, kMiddle = 1, kLast = 2;
    Zones zones_;
};

ShownBody shownTissue(std::shared_ptr<const TriangleMesh> mesh, const Pose& pose, TissueZones::Zones zones,
                      std::vector<Appearance> appearances) {
    return {std::move(mesh), pose, std::move(appearances), std::make_shared<const TissueZones>(std::move(zones))};
}

/// Of the three zones of a soft tissue.
std::vector<Appearance> appearancesOf(SoftTissueKind kind) {
    switch (kind) {
        case SoftTissueKind::Tongue:
            return {appearances::mucosa(), appearances::tongueSide(), appearances::tongue()};
        case SoftTissueKind::Cheek:
            return {appearances::mucosa()};
        case SoftTissueKind::Lips:
            return {appearances::mucosa(), appearances::lip(), appearances::skin()};
        case SoftTissueKind::Throat:
            return {appearances::mucosa(), appearances::mucosa(), appearances::throat()};
        case SoftTissueKind::Ring:
            return {appearances::retractor()};
    }
    return {};
}

ShownBody shownGingiva(std::shared_ptr<const TriangleMesh> mesh, const Pose& pose, TissueZones::Zones zones) {
    return shownTissue(std::move(mesh), pose, std::move(zones),
                       {appearances::freeGingiva(), appearances::gingiva(), appearances::mucosa()});
}

/// A tooth without its layers: the enamel is thin at the neck, where dentin shines through, and without dentin at the
/// edge of a front tooth.
class CrownZones : public AppearanceZones {
public:
    /// `toothInBody`: from its own frame, with the neck at height 0.
    CrownZones(int fdi, const Pose& toothInBody, const Box3& tooth)
        : bodyInTooth_(toothInBody.inverse()), top_(tooth.max().z()), isFront_(fdi % 10 <= 3) {}
    [[nodiscard]] AppearanceMix at(const Place& place) const override {
        constexpr double kNeck = 0.5,
                         kThick = 4.5;  // mm: here the enamel is thinnest, and here it has its full strength
        constexpr double kEdge = 2.8, kBare = 0.3;  // mm below the edge: here dentin begins to end, here it has ended
        const double height = (bodyInTooth_ * place.point).z();
        if (isFront_ && height > top_ - kEdge)
            return share(kIncisal, 0.7 * (height - (top_ - kEdge)) / (kEdge - kBare));
        return share(kThin, 0.9 * (kThick - height) / (kThick - kNeck));
    }
    static std::vector<Appearance> appearances() {
        return {toothAppearance(), appearances::thinEnamel(), appearances::incisalEnamel()};
    }

private:
    static constexpr SurfaceTag kEnamel = 0, kThin = 1, kIncisal = 2;
    static AppearanceMix share(SurfaceTag other, double part) {
        return {kEnamel, other, static_cast<std::uint8_t>(std::lround(255 * smoothStep(0, 1, part)))};
    }
    Pose bodyInTooth_;
    double top_;
    bool isFront_;
};

ShownBody shownTooth(std::shared_ptr<const TriangleMesh> mesh, const Pose& pose, const CrownZones& zones) {
    return {std::move(mesh), pose, CrownZones::appearances(), std::make_shared<const CrownZones>(zones)};
}

}  // namespace

std::vector<ShownBody> shownAround(std::span<const ToothInMouth::Body> around) {
    std::vector<ShownBody> bodies;
    for (const ToothInMouth::Body& body : around) {
        bodies.push_back(body.isGingiva ? shownGingiva(body.shown, {}, body.zones)
                                        : shownTooth(body.shown, {}, {body.fdi, body.bodyInTooth, body.ownBox}));
        bodies.back().opposite = body.isOpposite;
        if (body.isBeyond) bodies.back().beyond = ShownBody::Beyond{body.part};
        if (body.ownHalf) {
            const auto& [toOwnSide, half, zones] = *body.ownHalf;
            bodies.back().beyond =
                ShownBody::Beyond{body.part, Plane{toOwnSide, toOwnSide.dot(body.bodyInTooth.position)}, half,
                                  std::make_shared<const TissueZones>(zones)};
        }
    }
    return bodies;
}

std::vector<ShownTissue> shownSoftTissues(std::span<const SoftTissueBody> tissues) {
    std::vector<ShownTissue> shown;
    for (const auto& [kind, surface, zones] : tissues)
        shown.push_back({surface, appearancesOf(kind), std::make_shared<const TissueZones>(zones)});
    return shown;
}

std::vector<ShownTissue> shownSoftTissues(const BuiltinMouth& mouth) {
    return shownSoftTissues(softTissueBodies(mouth, 0, {}));
}

std::vector<ShownBody> shownMouth(const BuiltinMouth& mouth, ShownJaws jaws) {
    std::vector<ShownBody> bodies;
    const bool upper = jaws != ShownJaws::Lower, lower = jaws != ShownJaws::Upper;
    const auto addGingiva = [&](const ZonedMesh& gingiva, const Pose& pose) {
        bodies.push_back(shownGingiva(std::make_shared<const TriangleMesh>(gingiva.mesh), pose,
                                      std::make_shared<const std::vector<std::uint8_t>>(gingiva.zones)));
    };
    if (upper) addGingiva(mouth.upperShown, {});
    if (lower) addGingiva(mouth.lowerShown, mouth.lowerJaw);
    for (const MouthTooth& tooth : mouth.teeth) {
        if (tooth.tooth.fdi < 30 ? !upper : !lower) continue;
        auto mesh = std::make_shared<const TriangleMesh>(supragingivalMesh(tooth.tooth.outer));
        bodies.push_back(
            shownTooth(std::move(mesh), mouth.poseOf(tooth), {tooth.tooth.fdi, {}, boundingBox(tooth.tooth.outer)}));
    }
    return bodies;
}

}  // namespace tactooth
