// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_builder.h"

#include <gtest/gtest.h>

#include "app/common/inspection.h"
#include "app/common/spray_particles.h"
#include "geometry/util/pose.h"
#include "session/io/material_file.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

SceneContents contentsWithEverything() {
    SceneContents contents;
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(test::box(Vec3(-5, -5, -10), Vec3(5, 5, 7)));
    contents.tooth = surface;
    contents.tool = ShownTool{.bur = std::make_shared<const TriangleMesh>(test::sphere(Vec3::Zero(), 1, 8, 8)),
                              .turbine = std::make_shared<const TriangleMesh>(test::box(-Vec3::Ones(), Vec3::Ones())),
                              .material = BurMaterial::Diamond,
                              .toolInTooth = {Vec3(1, 2, 3), Quat::Identity()},
                              .spin = 0.5};
    contents.mirror = ShownMirror{.mesh = std::make_shared<const TriangleMesh>(test::box(-Vec3::Ones(), Vec3::Ones())),
                                  .disc = {.radius = 9},
                                  .mirrorInTooth = {Vec3(0, -12, 5), Quat::Identity()}};
    return contents;
}

TEST(SceneBuilder, ShowsToothBurTurbineAndMirror) {
    const Scene scene = makeScene(contentsWithEverything());
    ASSERT_EQ(scene.objects.size(), 4U);
    EXPECT_EQ(scene.objects[1].spin, 0.5);
    EXPECT_EQ(scene.objects[1].objectInWorld.position, Vec3(1, 2, 3));
    EXPECT_EQ(scene.objects[2].spin, 0) << "only the bur turns in the turbine";
    ASSERT_TRUE(scene.mirror.has_value());
    EXPECT_EQ(scene.mirror->radius, 9);
    EXPECT_EQ(scene.mirror->mirrorInWorld.position, Vec3(0, -12, 5));
}

TEST(SceneBuilder, TheShankOfADiamondBurIsSmooth) {
    SceneContents contents = contentsWithEverything();
    contents.tool->head = {.length = 1.5, .radius = 1, .neck = 0.6};
    const SceneObject diamond = makeScene(contents).objects[1];
    ASSERT_EQ(diamond.appearances.size(), 2U);
    EXPECT_GT(diamond.appearances[0].grain, 0.5F);
    EXPECT_LT(diamond.appearances[1].grain, 0.1F);
    EXPECT_EQ(diamond.secondAbove, 1.5F);
    contents.tool->material = BurMaterial::Carbide;
    EXPECT_FALSE(makeScene(contents).objects[1].secondAbove);
}

TEST(SceneBuilder, ASectionTakesNothingFromInstruments) {
    SceneContents contents = contentsWithEverything();
    contents.suction = ShownSuction{contents.mirror->mesh, {}};
    contents.tool->blurred = contents.tool->bur;
    contents.tool->speedRpm = 300000;
    Scene scene = makeScene(contents);
    const auto tooth = LayeredTooth::make(test::box(Vec3(-5, -5, -10), Vec3(5, 5, 7)), {});
    ASSERT_TRUE(tooth);
    Inspection inspection;
    inspection.section = Plane{Vec3::UnitY(), 0};
    applyInspection(scene, *tooth, inspection);
    ASSERT_TRUE(scene.section);
    const auto isSectioned = [&](const TriangleMesh* mesh) {
        return std::ranges::any_of(scene.objects, [&](const SceneObject& object) {
            const auto* shape = std::get_if<std::shared_ptr<const TriangleMesh>>(&object.shape);
            return shape != nullptr && shape->get() == mesh && object.sectioned;
        });
    };
    EXPECT_TRUE(scene.objects.front().sectioned);
    for (const auto& mesh : {contents.tool->bur, contents.tool->turbine, contents.mirror->mesh}) {
        EXPECT_FALSE(isSectioned(mesh.get()));
    }
}

TEST(SceneBuilder, AStillBurShowsItsBladesAndAFastOneTheBodyTheySweep) {
    SceneContents contents = contentsWithEverything();
    contents.tool->blurred = std::make_shared<const TriangleMesh>(test::sphere(Vec3::Zero(), 1.1, 8, 8));
    EXPECT_EQ(makeScene(contents).objects.size(), 4U);
    contents.tool->speedRpm = 60;
    const Scene slow = makeScene(contents);
    ASSERT_EQ(slow.objects.size(), 5U);
    contents.tool->speedRpm = 300000;
    const Scene fast = makeScene(contents);
    EXPECT_EQ(std::get<0>(fast.objects[2].shape), contents.tool->blurred);
    EXPECT_GT(fast.objects[2].appearances.front().opacity, 2 * slow.objects[2].appearances.front().opacity);
    EXPECT_LT(fast.objects[2].appearances.front().opacity, 1);
    // The picture of the blades no longer depends on the moment.
    EXPECT_EQ(slow.objects[1].spin, 0.5);
    EXPECT_EQ(fast.objects[1].spin, 0);
}

TEST(SceneBuilder, ManyBladesRunIntoEachOtherSoonerThanFewAndGrainsSoonerStill) {
    SceneContents contents = contentsWithEverything();
    contents.tool->blurred = std::make_shared<const TriangleMesh>(test::sphere(Vec3::Zero(), 1.1, 8, 8));
    contents.tool->speedRpm = 20;
    const auto cover = [&](const BurEdge& edge) {
        contents.tool->edge = edge;
        return makeScene(contents).objects.at(2).appearances.front().opacity;
    };
    EXPECT_NEAR(cover({12, 0}), 2 * cover({6, 0}), 1e-6F);
    EXPECT_GT(cover({0, 100}), cover({30, 0}));
}

TEST(SceneBuilder, TheSuctionTubeOpensBesideTheCrownAndLeavesDistally) {
    const Box3 tooth(Vec3(-5, -5, -10), Vec3(5, 5, 7));
    for (const double mesialX : {1.0, -1.0}) {
        const Pose tube = parkedSuction(tooth, mesialX);
        EXPECT_GT(-mesialX * tube.position.x(), 5);
        EXPECT_LT(-mesialX * tube.position.x(), 12);
        EXPECT_NEAR(tube.position.z(), 7, 2);
        const Vec3 away = tube.rotation * Vec3::UnitZ();
        EXPECT_GT(-mesialX * away.x(), 0.5);
        EXPECT_GT(away.z(), 0.3);
    }
}

TEST(SceneBuilder, WaterAndChipsHaveTheirColours) {
    MaterialTable materials;
    materials[test::kDentin].colour = {0.5F, 0.25F, 0.1F};
    SprayParticle chip, drop;
    chip.kind = SprayParticleKind::Chip;
    chip.material = test::kDentin;
    chip.lifetime = drop.lifetime = 1;
    chip.radius = drop.radius = 0.1F;
    drop.place = Vec3f(1, 2, 3);
    SprayParticle wet = chip, old = drop;
    wet.wetness = 1;
    old.age = 0.9F;
    const SprayParticle all[] = {chip, wet, drop, old};
    const std::vector<Particle> seen = particlesOf(all, materials);
    ASSERT_EQ(seen.size(), 4U);
    EXPECT_TRUE(seen[0].colour.isApprox(Vec3f(0.8F, 0.7F, 0.64F), 1e-6F)) << "paler than the solid, of the same hue";
    const auto yellowness = [](const Particle& particle) { return particle.colour.x() - particle.colour.z(); };
    EXPECT_LT(yellowness(seen[1]), 0.6 * yellowness(seen[0])) << "wet";
    EXPECT_EQ(seen[2].position, Vec3f(1, 2, 3));
    EXPECT_LT(seen[3].opacity, 0.2 * seen[2].opacity);
}

TEST(SceneBuilder, WaterWetsEverythingButBloodAndSlurryStayOnTheTooth) {
    SceneContents contents = contentsWithEverything();
    contents.around.push_back({.mesh = contents.mirror->mesh, .bodyInTooth = {}, .appearances = {Appearance{}}});
    contents.liquids = {.spot = Vec3(1, 2, 3), .water = 0.7, .slurry = 0.4, .opening = Vec3(0, 0, 2), .blood = 1.1};
    const Scene scene = makeScene(contents);
    EXPECT_EQ(scene.objects.front().liquids, contents.liquids);
    EXPECT_EQ(scene.objects.back().liquids.water, 0.7);
    EXPECT_EQ(scene.objects.back().liquids.spot, Vec3(1, 2, 3));
    EXPECT_EQ(scene.objects.back().liquids.blood, 0);
    EXPECT_EQ(scene.objects.back().liquids.slurry, 0);
    for (std::size_t i = 1; i + 1 < scene.objects.size(); ++i) {
        EXPECT_EQ(scene.objects[i].liquids, SurfaceLiquids()) << "an instrument";
    }
}

TEST(SceneBuilder, DirtOnTheMirrorTakesLight) {
    SceneContents contents = contentsWithEverything();
    const float clean = makeScene(contents).mirror->dimmedReflectance();
    EXPECT_EQ(clean, SceneMirror().reflectance);
    contents.mirror->dirt = 0.75F;
    EXPECT_NEAR(makeScene(contents).mirror->dimmedReflectance(), 0.75F * clean, 1e-6F);
}

TEST(SceneBuilder, WhatIsNotThereIsNotDrawn) {
    const Scene scene = makeScene({});
    EXPECT_TRUE(scene.objects.empty());
    EXPECT_FALSE(scene.mirror.has_value());
}

TEST(SceneBuilder, EachMaterialIsDrawnInTheColourOfItsTable) {
    SceneContents contents = contentsWithEverything();
    contents.materials[test::kPulp].colour = {0.25F, 0.5F, 0.75F};
    const std::vector<Appearance> drawn = makeScene(contents).objects[0].appearances;
    ASSERT_EQ(drawn.size(), builtinMaterials().size());
    EXPECT_EQ(drawn[static_cast<std::size_t>(test::kPulp)].colour, Vec3f(0.25F, 0.5F, 0.75F));
}

TEST(SceneBuilder, AMaterialOfTheUsersIsDrawnOpaqueInItsOwnColour) {
    const auto registry =
        parseMaterials("[amalgam]\ncolour = [0.5, 0.5, 0.75]\nroughness = 0.125\nmetalness = 0.75\n", "mine.toml");
    ASSERT_TRUE(registry) << registry.error().message();
    const auto amalgam = static_cast<std::size_t>((*registry)->find("amalgam").value());
    TriangleMesh outer = test::box(Vec3(-5, -5, -10), Vec3(5, 5, 7));
    auto tooth = LayeredTooth::make(outer, {{"amalgam", static_cast<MaterialId>(amalgam), outer}},
                                    static_cast<MaterialId>(amalgam), {}, **registry);
    ASSERT_TRUE(tooth) << tooth.error().message();
    SceneContents contents = contentsWithEverything();
    contents.materials = MaterialTable(**registry);
    Scene scene = makeScene(contents);
    Inspection inspection;
    inspection.opacity[static_cast<std::size_t>(test::kEnamel)] = 0.5F;
    applyInspection(scene, *tooth, inspection);
    const Appearance& drawn = scene.objects[0].appearances[amalgam];
    EXPECT_EQ(drawn.colour, Vec3f(0.5F, 0.5F, 0.75F));
    EXPECT_EQ(drawn.roughness, 0.125F);
    EXPECT_EQ(drawn.metalness, 0.75F);
    EXPECT_EQ(drawn.opacity, 1);
    EXPECT_EQ(scene.objects[1].appearances[0].colour, drawn.colour) << "its layer, seen through the enamel";
    EXPECT_EQ(scene.objects[1].appearances[0].opacity, 1);
}

TEST(SceneBuilder, WhatStandsAroundIsDrawnButTheOtherJawOnlyWhereItHidesNothing) {
    const auto ball = std::make_shared<const TriangleMesh>(test::sphere(Vec3::Zero(), 1, 8, 8));
    SceneContents contents;
    contents.around = {
        {.mesh = ball, .bodyInTooth = {}, .appearances = {appearances::enamel()}},
        {.mesh = ball, .bodyInTooth = {Vec3(0, 0, 20), Quat::Identity()}, .appearances = {{}}, .opposite = true}};
    contents.camera.cameraInWorld = {Vec3(0, 0, 90), Quat::Identity()};  // from above
    EXPECT_EQ(makeScene(contents).objects.size(), 1U);
    contents.camera.cameraInWorld.rotation = shortestRotation(Vec3::UnitZ(), Vec3::UnitY());
    const Scene scene = makeScene(contents);
    ASSERT_EQ(scene.objects.size(), 2U);
    EXPECT_EQ(scene.objects[1].objectInWorld.position, Vec3(0, 0, 20));
}

/// A wall across y that faces +y.
TriangleMesh wallAt(double y) {
    TriangleMesh wall;
    for (const auto& [x, z] : {std::pair(-40, -40), {40, -40}, {40, 40}, {-40, 40}})
        wall.vertices.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    wall.triangles = {{0, 2, 1}, {0, 3, 2}};
    return wall;
}

/// The eye at `place`, which looks at the origin.
Camera eyeAt(const Vec3& place) {
    Camera camera;
    camera.cameraInWorld = {place, shortestRotation(Vec3::UnitZ(), place.normalized())};
    return camera;
}

TEST(SceneBuilder, ASoftTissueIsDrawnWhereItHidesNothing) {
    SceneContents contents = contentsWithEverything();
    const std::size_t before = makeScene(contents).objects.size();
    contents.softTissues = {{std::make_shared<const Surface>(Surface{std::make_shared<const SurfacePart>(wallAt(30))}),
                             {appearances::mucosa()},
                             nullptr}};
    const auto drawnFrom = [&](const Vec3& eye) {
        contents.camera = eyeAt(eye);
        return makeScene(contents).objects.size() - before;
    };
    EXPECT_EQ(drawnFrom(Vec3(0, -90, 5)), 1U) << "behind the tooth";
    EXPECT_EQ(drawnFrom(Vec3(0, 90, 5)), 0U) << "before the tooth";
    EXPECT_EQ(drawnFrom(Vec3(0, 20, 30)), 1U) << "the eye is before it";
    contents.softTissues[0].surface =
        std::make_shared<const Surface>(Surface{std::make_shared<const SurfacePart>(wallAt(-30))});
    EXPECT_EQ(drawnFrom(Vec3(0, -90, 5)), 1U) << "the eye sees through it from behind";
    contents.mirror->mirrorInTooth.position = Vec3(0, -40, 0);
    EXPECT_EQ(drawnFrom(Vec3(0, 90, 5)), 0U) << "it would hide the mirror";
    contents.mirror->mirrorInTooth.position = Vec3(0, -20, 0);
    contents.camera = eyeAt(Vec3(0, 90, 5));
    const SceneObject& drawn = makeScene(contents).objects.back();
    EXPECT_TRUE(drawn.backdrop);
    EXPECT_EQ(std::get<std::shared_ptr<const TriangleMesh>>(drawn.shape)->triangles.size(), 2U);
}

TEST(SceneBuilder, TheOtherSideOfTheJawIsLeftOutWhereItHidesTheTooth) {
    const auto mesh = [](double y) {
        return std::make_shared<const TriangleMesh>(test::sphere(Vec3(0, y, 4), 6, 8, 8));
    };
    const auto part = [&](double y) { return std::make_shared<const SurfacePart>(*mesh(y)); };
    SceneContents contents = contentsWithEverything();
    const std::size_t before = makeScene(contents).objects.size();
    const auto half = mesh(-10);
    // A tooth on the other side, the gum that reaches from there to the own side, and a tooth on the own side.
    const Plane midline{Vec3::UnitY(), -22};
    contents.around = {
        {.mesh = mesh(-40), .bodyInTooth = {}, .appearances = {{}}, .beyond = ShownBody::Beyond{part(-40)}},
        {.mesh = mesh(-45),
         .bodyInTooth = {},
         .appearances = {{}},
         .beyond = ShownBody::Beyond{part(-45), midline, half, nullptr}},
        {.mesh = mesh(10), .bodyInTooth = {}, .appearances = {{}}}};
    contents.camera = eyeAt(Vec3(0, 90, 5));
    EXPECT_EQ(makeScene(contents).objects.size() - before, 3U);
    contents.camera = eyeAt(Vec3(0, -90, 5));
    const Scene scene = makeScene(contents);
    ASSERT_EQ(scene.objects.size() - before, 2U);
    EXPECT_EQ(std::get<std::shared_ptr<const TriangleMesh>>(scene.objects[before].shape), half);
    // What is on the own side stays, whatever it hides.
    contents.around.resize(1);
    contents.around[0].beyond->midline = Plane{Vec3::UnitY(), -60};
    EXPECT_EQ(makeScene(contents).objects.size() - before, 1U);
}

/// Law of reflection: the ray from the eye to the middle of the glass is reflected to the lingual side.
TEST(SceneBuilder, TheParkedMirrorShowsTheLingualSideToTheEye) {
    const Box3 tooth(Vec3(-5, -5, -10), Vec3(5, 5, 7));
    const MirrorDisc disc{.radius = 10};
    const Vec3 toEye = Vec3(0.3, 0.8, 0.5).normalized();
    const Pose mirror = parkedMirror(tooth, toEye, 1);
    const Vec3 normal = mirror.rotation * disc.normal;
    const Vec3 centre = mirror * disc.centre;
    const Vec3 onward = -toEye + 2 * toEye.dot(normal) * normal;
    const double reach = (tooth.min().y() - centre.y()) / onward.y();
    ASSERT_GT(reach, 0);
    const Vec3 seen = centre + reach * onward;
    EXPECT_NEAR(seen.x(), 0, 1e-9);
    EXPECT_GT(seen.z(), 0);
    EXPECT_LT(seen.z(), 7);
}

TEST(SceneBuilder, TheMirrorAndTheGripOfTheOtherSideAreMirrorImages) {
    const Box3 tooth(Vec3(-5, -5, -10), Vec3(5, 5, 7));
    const MirrorDisc disc{.radius = 10};
    const Pose one = parkedMirror(tooth, Vec3(0.3, 0.8, 0.5).normalized(), 1);
    const Pose other = parkedMirror(tooth, Vec3(-0.3, 0.8, 0.5).normalized(), -1);
    const auto inX = [](const Vec3& v) { return Vec3(-v.x(), v.y(), v.z()); };
    EXPECT_TRUE((one * disc.centre).isApprox(inX(other * disc.centre), 1e-12));
    EXPECT_TRUE((one.rotation * disc.normal).isApprox(inX(other.rotation * disc.normal), 1e-12));
    EXPECT_TRUE((one.rotation * Vec3::UnitX()).isApprox(inX(other.rotation * Vec3::UnitX()), 1e-12));
    const Vec3 handle = uprightGrip(1, 0.4) * Vec3::UnitX();
    EXPECT_GT(handle.x(), 0.9);
    EXPECT_LT(handle.y(), -0.3);
    EXPECT_TRUE((uprightGrip(-1, 0.4) * Vec3::UnitX()).isApprox(inX(handle), 1e-12));
}

}  // namespace
}  // namespace tactooth
