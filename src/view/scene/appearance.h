// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// How a metal surface was worked.
enum class Finish {
    Smooth,
    Machined,  ///< a handpiece, in its tool frame: brushed, knurled grip, spray holes and a light in the head's face
};

/// The appearance of a material.
struct Appearance {
    Vec3f colour = Vec3f(0.8F, 0.8F, 0.8F);  ///< sRGB, 0..1, as in a colour picker
    float roughness = 0.5F;                  ///< 0 = polished, 1 = matt
    float metalness = 0;                     ///< 1 = metal: reflects in its own colour
    float translucency = 0;                  ///< 0..1: how far light scatters around edges inside the material
    float wetness = 0;                       ///< 0..1: film of saliva or water, which gives sharp highlights
    float grain = 0;                         ///< 0..1: fine variation of surface and colour
    float opacity = 1;                       ///< 0..1: below 1 the background shows through, most at perpendicular view
    float hiddenOpacity = 1;                 ///< 0..1: of an opaque line of a ghost, where the tooth hides it
    Finish finish = Finish::Smooth;          ///< of metal
};

/// sRGB to linear light, channel by channel.
[[nodiscard]] Vec3f linearColour(const Vec3f& srgb);

/// The materials of this simulator, in one place so that all pictures agree.
namespace appearances {

[[nodiscard]] Appearance enamel();
[[nodiscard]] Appearance thinEnamel();     ///< dentin shines through it
[[nodiscard]] Appearance incisalEnamel();  ///< without dentin behind it: translucent, grey and bluish
[[nodiscard]] Appearance dentin();
[[nodiscard]] Appearance whiteSpot();        ///< enamel that acid has made porous: chalky white
[[nodiscard]] Appearance cutEnamel();        ///< ground: matt and chalky
[[nodiscard]] Appearance cutDentin();        ///< ground: smeared, glossy
[[nodiscard]] Appearance scleroticDentin();  ///< hardened around decay: darker, glassy
[[nodiscard]] Appearance affectedDentin();   ///< softened at the border of decay: leathery, amber
[[nodiscard]] Appearance pulp();
[[nodiscard]] Appearance caries();
[[nodiscard]] Appearance gingiva();      ///< keratinised and attached: pale, stippled
[[nodiscard]] Appearance freeGingiva();  ///< its margin around the teeth: smooth
[[nodiscard]] Appearance mucosa();       ///< beyond the mucogingival line: red and shiny
[[nodiscard]] Appearance lip();          ///< its red border
[[nodiscard]] Appearance skin();
[[nodiscard]] Appearance tongue();      ///< its back: rough with papillae
[[nodiscard]] Appearance tongueSide();  ///< smooth
[[nodiscard]] Appearance throat();      ///< where little light comes
[[nodiscard]] Appearance retractor();   ///< silicone that holds the lips
[[nodiscard]] Appearance bone();
[[nodiscard]] Appearance steel();       ///< mirror frame, hand instruments
[[nodiscard]] Appearance handpiece();   ///< machined steel
[[nodiscard]] Appearance carbide();     ///< tungsten carbide bur head
[[nodiscard]] Appearance diamond();     ///< diamond-coated bur head
[[nodiscard]] Appearance toCut();       ///< wall of a cavity to be cut, as a ghost: blue means still to cut
[[nodiscard]] Appearance outline();     ///< rim of the cavity to be cut
[[nodiscard]] Appearance outlineGap();  ///< parts of the rim that are not drawn where the tooth hides them

}  // namespace appearances

}  // namespace tactooth
