// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/bench_mouth.h"

#include "app/common/mouth_scene.h"
#include "geometry/util/pose.h"
#include "instruments/mirror.h"
#include "session/simulation/tooth_cache.h"

namespace tactooth {

Expected<Scene> benchMouth(bool withSoftTissues) {
    const ToothCache cache(defaultCacheFolder());
    const Expected<BuiltinMouth> mouth = cache.makeMouth({.jaw = JawPose::Open, .missing = {}});
    if (!mouth) return Unexpected{mouth.error()};
    SceneContents contents;
    contents.around = shownMouth(*mouth);
    if (withSoftTissues) contents.softTissues = shownSoftTissues(*mouth);
    DentalMirror mirror = makeMirror();
    const Vec3 glass(8, -34, -18);  // next to the tongue, above the lingual side of the lower right molars
    const MouthTooth& molar = *mouth->find(46);
    const Vec3 toMolar = (mouth->poseOf(molar) * boundingBox(molar.tooth.outer).center() - glass).normalized();
    const Vec3 toEye(0, 0.92, 0.39);  // the start direction of the frames: from the front and slightly above
    const Pose held{glass, shortestRotation(Vec3::UnitZ(), (toEye + toMolar).normalized())};
    contents.mirror = ShownMirror{std::make_shared<const TriangleMesh>(std::move(mirror.surface)), mirror.disc, held};
    return makeScene(contents);
}

}  // namespace tactooth
