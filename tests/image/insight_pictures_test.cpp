// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Compares pictures of views into a tooth, and of particles in the air around it, with stored pictures.
#include "assessment/cavity_ghost.h"
#include "geometry/util/pose.h"
#include "image/molar_fixture.h"
#include "session/simulation/cut_model.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::objectOf;

class InsightPictures : public test::MolarPictures {
protected:
    static std::vector<Appearance> materialAppearances() {
        return {appearances::enamel(), appearances::dentin(), appearances::pulp(),
                appearances::bone(),   appearances::bone(),   appearances::caries()};
    }
    static Appearance appearanceOf(MaterialId id) { return materialAppearances()[static_cast<std::size_t>(id)]; }

    static SceneObject body(std::shared_ptr<const Surface> surface) {
        SceneObject object;
        object.shape = std::move(surface);
        object.appearances = materialAppearances();
        object.sectioned = true;
        object.capAppearance = appearanceOf(tooth_->body());
        return object;
    }
    static SceneObject layer(const LayeredTooth::Layer& from) {
        SceneObject object;
        object.shape = std::shared_ptr<const TriangleMesh>(from.part, &from.part->mesh());
        object.appearances = {appearanceOf(from.material)};
        object.capAppearance = object.appearances.front();
        object.sectioned = object.inner = true;
        object.visible = false;
        return object;
    }
    /// The tooth, uncut or with a slot of 0.8 mm radius across its fossa, and its layers.
    static std::vector<SceneObject> molar(bool cut) {
        CutModel piece(tooth_, 0.05);
        if (cut) {
            const TriangleMesh bur = test::cylinder(Vec3::Zero(), 0.8, 6, 32);
            const double top = tooth_->outer()->tree().box().max().z();
            const Pose from{Vec3(-1.5, 0, top - 3.2), Quat::Identity()};
            const Pose to{Vec3(1.5, 0, top - 3.2), Quat::Identity()};
            piece.sweep({*RevolutionEnvelope::make(bur), 1}, from, to);
            piece.refreshSurface();
        }
        std::vector<SceneObject> objects{body(piece.surface())};
        for (const LayeredTooth::Layer& from : tooth_->layers()) objects.push_back(layer(from));
        return objects;
    }
    /// The tooth with a slot across its fossa, `depth` mm below its highest cusp.
    static std::shared_ptr<const Surface> slotted(double radius, double halfLength, double depth) {
        CutModel piece(tooth_, 0.05);
        const TriangleMesh bur = test::cylinder(Vec3::Zero(), radius, 8, 32);
        const double z = tooth_->outer()->tree().box().max().z() - depth;
        const CuttingTool tool{*RevolutionEnvelope::make(bur), 1};
        piece.sweep(tool, {Vec3(-halfLength, 0, z), Quat::Identity()}, {Vec3(halfLength, 0, z), Quat::Identity()});
        piece.refreshSurface();
        return piece.surface();
    }
    /// `tooth` with the ghost of a slot of 1.2 mm radius and 4.8 mm length that is still to be cut.
    static std::vector<SceneObject> withGhost(const std::shared_ptr<const Surface>& tooth) {
        CavityGhost cavity(visibleMesh(*slotted(1.2, 2.4, 4.2)).mesh, *tooth_->outer());
        SceneObject ghost;
        ghost.shape = cavity.over(tooth);
        ghost.appearances = {appearances::toCut(), appearances::outline(), appearances::outlineGap()};
        ghost.sectioned = ghost.ghost = true;
        return {body(tooth), ghost};
    }
    static std::shared_ptr<const Surface> uncut() { return CutModel(tooth_, 0.05).surface(); }
    static Scene seenFrom(std::vector<SceneObject> objects, OrbitCamera::Direction direction) {
        Scene scene = lit(std::move(objects), direction);
        OrbitCamera camera;
        Box3 crown = tooth_->outer()->tree().box();
        crown.min().z() = crown.max().z() - 8;
        camera.fit(crown, test::kTestSize.aspect());
        camera.setView(direction);
        scene.camera = camera.camera();
        scene.lighting = operatingLight(scene.camera);
        return scene;
    }
    static Scene openedFromBuccal(bool cut) {
        Scene scene = seenFrom(molar(cut), {1.3, 0.35});
        scene.section = Section{{Vec3::UnitY(), 0}};
        return scene;
    }
    static Scene glassy(bool cut) {
        Scene scene = seenFrom(molar(cut), {1.3, 0.7});
        scene.objects.front().appearances.front().opacity = 0.35F;
        for (SceneObject& object : scene.objects) object.visible = true;
        scene.objects[1].visible = false;  // enamel: its outside is the outside of the body
        return scene;
    }

    /// The cut molar in the colours of its distance to a ball.
    [[nodiscard]] static Scene coloured(const DistanceScale& scale) {
        Scene scene = seenFrom({molar(true).front()}, {1.4, 0.9});
        const SurfacePart target(test::sphere(Vec3(0, 0, 2), 5, 64, 32));
        const Box3 box = tooth_->outer()->tree().box();
        scene.objects.front().distances =
            DistanceColourMap{std::make_shared<const DistanceGrid>(sampleDistances(target, box, 48)), scale};
        return scene;
    }

    /// A mirror at such an angle that the eye of `scene` sees the crown in it.
    [[nodiscard]] SceneMirror mirrorBehindTheCrown(const Scene& scene) const {
        SceneMirror mirror;
        mirror.radius = 8;
        const Vec3 crown = tooth_->outer()->tree().box().center() + Vec3(0, 0, 6);
        mirror.mirrorInWorld.position = crown + Vec3(4, -10, 1);
        const Vec3 toEye = (scene.camera.cameraInWorld.position - mirror.mirrorInWorld.position).normalized();
        mirror.mirrorInWorld.rotation = shortestRotation(
            Vec3::UnitZ(), (toEye + (crown - mirror.mirrorInWorld.position).normalized()).normalized());
        return mirror;
    }
};

TEST_F(InsightPictures, FiveStandardViews) {
    const std::pair<const char*, StandardView> views[] = {{"view-occlusal", StandardView::Occlusal},
                                                          {"view-buccal", StandardView::Buccal},
                                                          {"view-lingual", StandardView::Lingual},
                                                          {"view-mesial", StandardView::Mesial},
                                                          {"view-distal", StandardView::Distal}};
    const std::vector<SceneObject> whole = molar(false);
    for (const auto& [name, view] : views) {
        OrbitCamera camera;
        camera.setView(view, mesialX_);
        expectBaseline(name, seenFrom({whole.front()}, camera.direction()));
    }
}

TEST_F(InsightPictures, CutSurfaceShowsItsLayers) {
    expectBaseline("cut", seenFrom({molar(true).front()}, {1.5, 1.2}));
}

TEST_F(InsightPictures, SectionShowsTheLayersFilled) { expectBaseline("section", openedFromBuccal(false)); }

TEST_F(InsightPictures, SectionOfACutToothIsEmptyWhereItWasCut) {
    expectBaseline("section-cut", openedFromBuccal(true));
}

TEST_F(InsightPictures, SectionInTheMirror) {
    Scene scene = openedFromBuccal(false);
    SceneMirror mirror;
    mirror.radius = 7;
    const Vec3 crown = tooth_->outer()->tree().box().center() + Vec3(0, 0, 6);
    mirror.mirrorInWorld.position = crown + Vec3(-9, 10, 0);
    const Vec3 toEye = (scene.camera.cameraInWorld.position - mirror.mirrorInWorld.position).normalized();
    const Vec3 toCrown = (crown - mirror.mirrorInWorld.position).normalized();
    mirror.mirrorInWorld.rotation = shortestRotation(Vec3::UnitZ(), (toEye + toCrown).normalized());
    scene.mirror = mirror;
    expectBaseline("section-mirror", scene);
}

TEST_F(InsightPictures, GlassyEnamelShowsDentinAndCaries) { expectBaseline("transparent", glassy(false)); }

TEST_F(InsightPictures, NothingOfALayerStandsInACavity) { expectBaseline("transparent-cut", glassy(true)); }

TEST_F(InsightPictures, ColoursByDistance) { expectBaseline("distances", coloured({.range = 2})); }

TEST_F(InsightPictures, ATolerance) { expectBaseline("distances-tolerance", coloured({.range = 2, .tolerance = 0.5})); }

TEST_F(InsightPictures, TheGhostOfACavityIsSeenThroughTheTooth) {
    expectBaseline("ghost-buccal", seenFrom(withGhost(uncut()), {1.4, 0.35}));
    expectBaseline("ghost-occlusal", seenFrom(withGhost(uncut()), {1.5, 1.3}));
}

TEST_F(InsightPictures, TheGhostIsGoneWhereTheToothIsCut) {
    expectBaseline("ghost-cut", seenFrom(withGhost(slotted(1.2, 0.9, 4.2)), {1.4, 1.0}));
}

TEST_F(InsightPictures, TheGhostIsCutByASection) {
    std::vector<SceneObject> objects = withGhost(uncut());
    for (const LayeredTooth::Layer& from : tooth_->layers()) objects.push_back(layer(from));
    Scene scene = seenFrom(std::move(objects), {1.3, 0.35});
    scene.section = Section{{Vec3::UnitY(), 0}};
    expectBaseline("ghost-section", scene);
}

TEST_F(InsightPictures, AnInstrumentHidesTheGhostBehindIt) {
    std::vector<SceneObject> objects = withGhost(uncut());
    SceneObject bur = objectOf(test::cylinder(Vec3::Zero(), 0.7, 9, 24), appearances::carbide());
    bur.objectInWorld.position = Vec3(-0.6, 0, tooth_->outer()->tree().box().max().z() - 1.5);
    bur.moves = true;
    objects.push_back(bur);
    expectBaseline("ghost-bur", seenFrom(std::move(objects), {1.4, 0.6}));
}

TEST_F(InsightPictures, TheGhostInTheMirror) {
    Scene scene = seenFrom(withGhost(uncut()), {1.3, 0.4});
    scene.mirror = mirrorBehindTheCrown(scene);
    expectBaseline("ghost-mirror", scene);
}

TEST_F(InsightPictures, TwoEyes) {
    Scene scene = seenFrom({molar(false).front()}, {1.3, 0.7});
    scene.stereo = {Stereo::Mode::SideBySide, 60, 2};
    expectBaseline("stereo-side-by-side", scene);
    scene.stereo.mode = Stereo::Mode::Anaglyph;
    expectBaseline("stereo-anaglyph", scene);
}

TEST_F(InsightPictures, FogAndDropsOnTheMirror) {
    Scene scene = seenFrom({molar(false).front()}, {1.3, 0.4});
    scene.mirror = mirrorBehindTheCrown(scene);
    scene.mirror->fog = 0.8F;
    expectBaseline("mirror-fog", scene);
    scene.mirror->fog = 0.3F;
    scene.mirror->dirt = 1;
    expectBaseline("breath", scene);
    scene.mirror->fog = scene.mirror->dirt = 0;
    scene.mirror->drops = 0.5F;
    expectBaseline("mirror-drops", scene);
}

TEST_F(InsightPictures, DropsAndChipsInTheAir) {
    Scene scene = seenFrom({molar(false).front()}, {1.3, 0.5});
    const Vec3f top = tooth_->outer()->tree().box().center().cast<float>() + Vec3f(0, 0, 10);
    for (int i = 0; i < 120; ++i) {
        const float angle = 2.4F * static_cast<float>(i);
        const float away = 0.35F * std::sqrt(static_cast<float>(i));
        const bool chip = i % 4 == 0;
        scene.particles.push_back({top + away * Vec3f(std::cos(angle), std::sin(angle), 0.3F * std::sin(3 * angle)),
                                   chip ? 0.08F : 0.16F, chip ? Vec3f(0.93F, 0.9F, 0.82F) : Vec3f(0.85F, 0.92F, 1.0F),
                                   chip ? 1.0F : 0.4F});
    }
    expectBaseline("spray", scene);
}

}  // namespace
}  // namespace tactooth
