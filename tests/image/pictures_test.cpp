// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Compares pictures of known scenes with stored ones. README.md in this folder explains how to renew them.
#include <cmath>

#include "geometry/util/pose.h"
#include "image/pictures_fixture.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::objectOf;
using test::Pictures;

/// A crown-like body: a ball with four cusps and a groove, mm.
TriangleMesh crown() {
    TriangleMesh mesh = test::sphere(Vec3::Zero(), 1, 120, 80);
    for (Vec3f& v : mesh.vertices) {
        const float cusps = 0.5F * (1 - std::cos(4 * std::atan2(v.y(), v.x()))) * std::hypot(v.x(), v.y());
        v = Vec3f(5 * v.x(), 4.5F * v.y(), (v.z() > 0 ? 3 : 6) * v.z() + (v.z() > 0 ? 1.5F * cusps : 0));
    }
    return mesh;
}

TEST_F(Pictures, Enamel) { expectBaseline("enamel", lit({objectOf(crown(), appearances::enamel())}, {1.0, 0.6})); }

TEST_F(Pictures, EnamelWithoutShadowsAndSamples) {
    expectBaseline("enamel-plain", lit({objectOf(crown(), appearances::enamel())}, {1.0, 0.6}),
                   {.shadows = Shadows::None});
}

TEST_F(Pictures, Materials) {
    const Appearance all[] = {appearances::enamel(), appearances::dentin(),  appearances::pulp(),
                              appearances::caries(), appearances::gingiva(), appearances::bone(),
                              appearances::steel(),  appearances::carbide(), appearances::diamond()};
    std::vector<SceneObject> balls;
    for (int i = 0; i < 9; ++i) {
        balls.push_back(objectOf(test::sphere(Vec3(2.2 * (i % 3), -2.2 * (i / 3), 0), 1, 64, 32), all[i]));
    }
    expectBaseline("materials", lit(balls, {-1.5707963, 1.5707963}));
}

TEST_F(Pictures, BurOnCrown) {
    SceneObject bur = objectOf(test::cylinder(Vec3::Zero(), 0.6, 9, 12), appearances::carbide());
    bur.objectInWorld = {Vec3(0.5, 0, 2.6), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX()))};
    bur.moves = true;
    expectBaseline("bur-on-crown", lit({objectOf(crown(), appearances::enamel()), bur}, {0.8, 0.7}));
}

TEST_F(Pictures, MirrorBehindCrown) {
    Scene scene = lit({objectOf(crown(), appearances::enamel()),
                       objectOf(test::sphere(Vec3(0, 4.6, 0), 0.7, 48, 24), appearances::caries())},
                      {-1.4, 0.3});
    SceneMirror mirror;
    mirror.radius = 5;
    mirror.mirrorInWorld.position = Vec3(4, 8, 2);
    const Vec3 toEye = (scene.camera.cameraInWorld.position - mirror.mirrorInWorld.position).normalized();
    const Vec3 toCaries = (Vec3(0, 4.6, 0) - mirror.mirrorInWorld.position).normalized();
    mirror.mirrorInWorld.rotation = shortestRotation(Vec3::UnitZ(), toEye + toCaries);
    scene.mirror = mirror;
    expectBaseline("mirror", scene);
}

}  // namespace
}  // namespace tactooth
