// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/tip_visibility.h"

#include <algorithm>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// The bur, or the cap of its head.
bool isOfBur(const SceneObject& object) { return object.moves && object.glassAbove && *object.glassAbove > 0; }

/// The scene with nothing but the bur, or nothing but the tooth.
Scene alone(const Scene& scene, bool bur) {
    Scene result = scene;
    for (SceneObject& object : result.objects) {
        object.visible = bur ? isOfBur(object) : &object == &result.objects.front();
    }
    return result;
}

/// Whether a pixel of an id picture shows the bur's head, through whatever glass.
bool showsHead(const Rgba& pixel, const Scene& scene) {
    return pixel[0] != 0 && isOfBur(scene.objects[pixel[0] - 1U]) && (pixel[1] & kBelowGlass) != 0;
}

/// Whether it shows the landing disc of the tooth, likewise.
bool showsLanding(const Rgba& pixel) { return pixel[0] == 1 && (pixel[1] & kInBall) != 0; }

bool isBright(const Rgba& pixel) { return pixel[2] >= 128; }

}  // namespace

Expected<TipVisibility> measureTipVisibility(OffscreenRenderer& renderer, const Scene& scene, ImageSize size) {
    TACTOOTH_ASSERT(scene.sight);
    TACTOOTH_ASSERT(std::ranges::any_of(scene.objects, isOfBur));
    const MarkedBall disc{scene.sight->start, kLandingDisc / 2};
    const auto all = renderer.identify(scene, size, disc);
    if (!all) return Unexpected{all.error()};
    const auto burAlone = renderer.identify(alone(scene, true), size, disc);
    if (!burAlone) return Unexpected{burAlone.error()};
    const auto toothAlone = renderer.identify(alone(scene, false), size, disc);
    if (!toothAlone) return Unexpected{toothAlone.error()};
    TipVisibility result;
    int head = 0, landing = 0;
    for (std::size_t i = 0; i < all->pixels.size(); ++i) {
        const Rgba& pixel = all->pixels[i];
        const bool seesHead = isBright(pixel) && showsHead(pixel, scene);
        if (showsHead(burAlone->pixels[i], scene)) {
            ++result.headPixels;
            head += seesHead ? 1 : 0;
        }
        if (showsLanding(toothAlone->pixels[i])) {
            ++result.landingPixels;
            landing += seesHead || (isBright(pixel) && showsLanding(pixel)) ? 1 : 0;
        }
    }
    result.head = static_cast<double>(head) / std::max(1, result.headPixels);
    result.landing = static_cast<double>(landing) / std::max(1, result.landingPixels);
    return result;
}

}  // namespace tactooth
