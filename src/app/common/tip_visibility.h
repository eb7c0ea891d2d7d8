// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/scene_builder.h"
#include "view/render/offscreen.h"

namespace tactooth {

/// How much of the bur's working end a picture shows. A pixel counts as seen if at least half of its light reaches the
/// eye.
struct TipVisibility {
    double head = 0;     ///< share of the head as the bur alone shows it, 0..1
    double landing = 0;  ///< share of the landing disc as the tooth alone shows it, 0..1; behind the head it counts as
                         ///< seen: a tool always covers what it touches
    int headPixels = 0;  ///< of the bur alone; the shares mean little if there are few
    int landingPixels = 0;  ///< of the tooth alone
};

/// The disc around the landing point that should stay visible, mm.
inline constexpr double kLandingDisc = 2;

/// Measures it in the pictures of the objects' ids. `scene`: of makeScene, with a tooth, a tool whose head is known,
/// and glass.
[[nodiscard]] Expected<TipVisibility> measureTipVisibility(OffscreenRenderer& renderer, const Scene& scene,
                                                           ImageSize size);

}  // namespace tactooth
