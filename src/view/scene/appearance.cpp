// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/scene/appearance.h"

#include <cmath>

namespace tactooth {

Vec3f linearColour(const Vec3f& srgb) {
    return srgb.unaryExpr([](float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); });
}

namespace appearances {

// Enamel has shade A1-A2 of the common tooth shade guides, dentin the two shades below (A3-A3.5). The others were
// chosen by eye from clinical photographs.
Appearance enamel() {
    return {
        .colour = {0.93F, 0.895F, 0.82F}, .roughness = 0.34F, .translucency = 0.75F, .wetness = 0.9F, .grain = 0.12F};
}
Appearance thinEnamel() {
    return {.colour = {0.92F, 0.85F, 0.70F}, .roughness = 0.36F, .translucency = 0.7F, .wetness = 0.9F, .grain = 0.12F};
}
Appearance incisalEnamel() {
    return {
        .colour = {0.84F, 0.84F, 0.81F}, .roughness = 0.30F, .translucency = 0.95F, .wetness = 0.95F, .grain = 0.08F};
}
Appearance dentin() {
    return {.colour = {0.90F, 0.80F, 0.60F}, .roughness = 0.62F, .translucency = 0.4F, .wetness = 0.22F, .grain = 0.3F};
}
Appearance whiteSpot() {
    return {.colour = {0.97F, 0.955F, 0.92F}, .roughness = 0.7F, .translucency = 0.3F, .wetness = 0.4F, .grain = 0.3F};
}
Appearance cutEnamel() {
    return {
        .colour = {0.945F, 0.92F, 0.87F}, .roughness = 0.75F, .translucency = 0.45F, .wetness = 0.2F, .grain = 0.3F};
}
Appearance cutDentin() {
    return {
        .colour = {0.90F, 0.78F, 0.55F}, .roughness = 0.38F, .translucency = 0.45F, .wetness = 0.55F, .grain = 0.2F};
}
Appearance scleroticDentin() {
    return {.colour = {0.76F, 0.58F, 0.34F}, .roughness = 0.30F, .translucency = 0.5F, .wetness = 0.6F, .grain = 0.15F};
}
Appearance affectedDentin() {
    return {.colour = {0.62F, 0.41F, 0.20F}, .roughness = 0.55F, .translucency = 0.3F, .wetness = 0.4F, .grain = 0.5F};
}
Appearance pulp() {
    return {.colour = {0.72F, 0.17F, 0.16F}, .roughness = 0.4F, .translucency = 0.6F, .wetness = 0.9F, .grain = 0.3F};
}
Appearance caries() {
    return {.colour = {0.36F, 0.22F, 0.11F}, .roughness = 0.75F, .translucency = 0.1F, .wetness = 0.25F, .grain = 0.9F};
}
Appearance gingiva() {
    return {.colour = {0.88F, 0.59F, 0.565F}, .roughness = 0.5F, .translucency = 0.7F, .wetness = 0.6F, .grain = 0.6F};
}
Appearance freeGingiva() {
    return {.colour = {0.86F, 0.53F, 0.51F}, .roughness = 0.42F, .translucency = 0.8F, .wetness = 0.8F, .grain = 0.3F};
}
Appearance mucosa() {
    return {.colour = {0.77F, 0.41F, 0.40F}, .roughness = 0.32F, .translucency = 0.8F, .wetness = 0.95F, .grain = 0.1F};
}
Appearance lip() {
    return {.colour = {0.74F, 0.38F, 0.37F}, .roughness = 0.42F, .translucency = 0.7F, .wetness = 0.5F, .grain = 0.35F};
}
Appearance skin() {
    return {.colour = {0.86F, 0.66F, 0.56F}, .roughness = 0.6F, .translucency = 0.6F, .wetness = 0.08F, .grain = 0.35F};
}
Appearance tongue() {
    return {.colour = {0.80F, 0.50F, 0.48F}, .roughness = 0.6F, .translucency = 0.7F, .wetness = 0.5F, .grain = 1.0F};
}
Appearance tongueSide() {
    return {.colour = {0.78F, 0.42F, 0.41F}, .roughness = 0.4F, .translucency = 0.8F, .wetness = 0.8F, .grain = 0.4F};
}
Appearance throat() {
    return {.colour = {0.40F, 0.15F, 0.14F}, .roughness = 0.6F, .translucency = 0.3F, .wetness = 0.5F, .grain = 0.2F};
}
Appearance retractor() {
    return {.colour = {0.72F, 0.82F, 0.90F}, .roughness = 0.35F, .translucency = 0.8F, .wetness = 0.3F};
}
Appearance bone() {
    return {.colour = {0.88F, 0.83F, 0.72F}, .roughness = 0.7F, .translucency = 0.3F, .wetness = 0.1F, .grain = 0.6F};
}
Appearance steel() { return {.colour = {0.83F, 0.84F, 0.86F}, .roughness = 0.14F, .metalness = 1.0F, .grain = 0.05F}; }
Appearance handpiece() {
    return {.colour = {0.80F, 0.81F, 0.83F},
            .roughness = 0.22F,
            .metalness = 1,
            .grain = 0.05F,
            .finish = Finish::Machined};
}
Appearance carbide() {
    return {.colour = {0.74F, 0.75F, 0.77F}, .roughness = 0.20F, .metalness = 1.0F, .grain = 0.06F};
}
Appearance diamond() { return {.colour = {0.60F, 0.59F, 0.57F}, .roughness = 0.5F, .metalness = 0.85F, .grain = 1.0F}; }
// Blue differs from all tissues, which range from white over yellow to red, for all common kinds of colour blindness
// (M. Okabe, K. Ito, Color universal design, 2008: their sky blue and blue).
Appearance toCut() { return {.colour = {0.34F, 0.71F, 0.91F}, .opacity = 0.62F}; }
Appearance outline() { return {.colour = {0.0F, 0.27F, 0.60F}, .hiddenOpacity = 0.8F}; }
Appearance outlineGap() {
    Appearance gap = outline();
    gap.hiddenOpacity = 0;
    return gap;
}

}  // namespace appearances

}  // namespace tactooth
