// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/common/tip_visibility.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_catalogue.h"
#include "view/renderer_fixture.h"

namespace tactooth::test {

/// A tooth of the built-in mouth as the window shows it, with handpiece, mirror and suction tube.
struct ToothToSee {
    double mesialX = 1;
    Box3 box;
    SceneContents contents;  ///< without camera and pose of the tool
};
[[nodiscard]] ToothToSee toothToSee(int fdi, const BurSpec& bur);

/// The bur where the mouse at one place of the picture brings it.
struct Aim {
    Camera camera;
    Pose tool;
    Vec3 heading;
};
/// Aims at nine places of the crown, of which those count that the picture shows, hovering; where the bur comes from
/// above also touching.
[[nodiscard]] std::vector<Aim> aimsAt(const ToothToSee& tooth, StandardView view, ImageSize size);

[[nodiscard]] Scene sceneOf(const ToothToSee& tooth, const Aim& aim);

inline constexpr ImageSize kPicture{700, 450};  // half of the window's
inline constexpr double kSeen = 0.9;

class TipVisibilityTest : public RendererTest {
protected:
    static TipVisibility measure(const Scene& scene);
    /// Checks every standard view of a tooth, with a bur of the catalogue.
    static void expectSeen(int fdi, const char* bur);
};

}  // namespace tactooth::test
