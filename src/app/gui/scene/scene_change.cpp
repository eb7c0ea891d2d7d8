// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/scene_change.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "app/common/spin_blur.h"

namespace tactooth {
namespace {

/// A twentieth of a pixel at the bur's rim: the slow end of a bur that runs down is not drawn.
constexpr double kSeenSpin = 0.003;  // rad
constexpr float kSeenBlur = 0.02F;   // of spinBlur

bool samePose(const Pose& a, const Pose& b) {
    constexpr double kSeen = 0.002;  // mm, and rad times the length of the tool: a twentieth of a pixel
    return (a.position - b.position).norm() < kSeen && a.rotation.angularDistance(b.rotation) < kSeen / 20;
}

/// Whether breath or dirt on the mirror has grown so much that one sees it. It is slow: each picture in between would
/// be one of motion.
bool isDimmed(const ShownMirror& now, const ShownMirror& drawn) {
    constexpr float kSeen = 0.05F;
    return std::abs(now.fog - drawn.fog) > kSeen || std::abs(now.dirt - drawn.dirt) > kSeen ||
           (now.fog == 0) != (drawn.fog == 0) || (now.dirt == 0) != (drawn.dirt == 0);
}

bool isOtherLiquid(const SurfaceLiquids& now, const SurfaceLiquids& drawn) {
    constexpr double kSeen = 0.02, kSeenReach = 0.03;  // of 1; mm
    const auto differ = [](double a, double b, double seen) {
        return std::abs(a - b) > seen || ((a == 0) != (b == 0));
    };
    return differ(now.water, drawn.water, kSeen) || differ(now.slurry, drawn.slurry, kSeen) ||
           differ(now.blood, drawn.blood, kSeenReach);
}

bool isOtherMoved(const std::optional<ShownOther>& now, const std::optional<ShownOther>& drawn) {
    if (now.has_value() != drawn.has_value()) return true;
    if (!now) return false;
    return now->tooth != drawn->tooth || now->tool.has_value() != drawn->tool.has_value() ||
           (now->tool && (now->tool->bur != drawn->tool->bur || now->tool->turbine != drawn->tool->turbine ||
                          !samePose(now->tool->toolInTooth, drawn->tool->toolInTooth)));
}

}  // namespace

FramePacer::Change sceneChange(const SceneContents& now, const SceneContents& drawn,
                               const std::function<bool()>& seesTip) {
    using enum FramePacer::Change;
    if (now.tooth != drawn.tooth || now.tool.has_value() != drawn.tool.has_value() ||
        now.mirror.has_value() != drawn.mirror.has_value() || now.suction.has_value() != drawn.suction.has_value() ||
        now.flying != drawn.flying || isOtherLiquid(now.liquids, drawn.liquids) ||
        isOtherMoved(now.other, drawn.other)) {
        return Motion;
    }
    if (now.mirror && (now.mirror->mesh != drawn.mirror->mesh || isDimmed(*now.mirror, *drawn.mirror) ||
                       now.mirror->drops != drawn.mirror->drops ||
                       !samePose(now.mirror->mirrorInTooth, drawn.mirror->mirrorInTooth))) {
        return Motion;
    }
    if (!now.tool) return None;
    if (now.tool->bur != drawn.tool->bur || now.tool->turbine != drawn.tool->turbine ||
        !samePose(now.tool->toolInTooth, drawn.tool->toolInTooth)) {
        return Motion;
    }
    const float blur = spinBlur(now.tool->speedRpm, now.tool->edge);
    if (std::abs(blur - spinBlur(drawn.tool->speedRpm, drawn.tool->edge)) > kSeenBlur) return Spin;
    if (blur == 1 && now.tool->blurred != nullptr) return None;  // a full blur looks the same at each angle
    const double turned = std::remainder(now.tool->spin - drawn.tool->spin, 2 * std::numbers::pi);
    return std::abs(turned) > kSeenSpin && seesTip() ? Spin : None;
}

}  // namespace tactooth
