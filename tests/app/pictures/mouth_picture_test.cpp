// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Teeth and gum of the mouth, against stored pictures (tests/image/README.md).
#include "app/common/mouth_scene.h"
#include "app/common/tooth_zones.h"
#include "image/pictures_fixture.h"
#include "session/simulation/cut_model.h"
#include "support/few_teeth.h"
#include "support/shapes.h"
#include "tooth/sweep/revolution_envelope.h"

namespace tactooth {
namespace {

/// The lower right first molar with decay, among its neighbours; made once.
class MouthPictures : public test::Pictures {
protected:
    static void SetUpTestSuite() {
        Pictures::SetUpTestSuite();
        auto made = toothInMouth(
            46, Lesion{},
            {.triangles = 6000, .jaw = JawPose::Open, .missing = test::allTeethExcept({43, 44, 45, 46, 47})});
        ASSERT_TRUE(made) << made.error().message();
        mouth_.emplace(std::move(*made));
        auto layered = layeredTooth(*mouth_);
        ASSERT_TRUE(layered) << layered.error().message();
        tooth_ = std::make_shared<const LayeredTooth>(std::move(*layered));
    }
    static void TearDownTestSuite() {
        mouth_.reset();
        tooth_.reset();
        Pictures::TearDownTestSuite();
    }
    /// `height`: of the picture, mm.
    static Scene seenFrom(const CutModel& piece, OrbitCamera::Direction direction, const Vec3& at, double height,
                          double water = 0, bool withSoftTissues = false) {
        SceneContents contents;
        contents.tooth = piece.surface();
        contents.zones = toothZones(*tooth_, contents.materials);
        contents.around = shownAround(mouth_->around);
        if (withSoftTissues) contents.softTissues = shownSoftTissues(mouth_->softTissues);
        contents.liquids = {.spot = at, .water = water};
        OrbitCamera camera;
        camera.setView(direction);
        camera.fit(Box3(at.array() - height / 2, at.array() + height / 2), test::kTestSize.aspect());
        contents.camera = camera.camera();
        return makeScene(contents);
    }
    static Vec3 crown() {
        const Box3 box = boundingBox(mouth_->tooth.outer);
        return {box.center().x(), box.center().y(), box.max().z() - 2};
    }
    static CutModel uncut() { return CutModel(tooth_, 0.1); }

    static inline std::optional<ToothInMouth> mouth_;
    static inline std::shared_ptr<const LayeredTooth> tooth_;
};

TEST_F(MouthPictures, TeethAmongTheirNeighbours) {
    expectBaseline("mouth", seenFrom(uncut(), {1.9, 0.8}, crown(), 22));
}

TEST_F(MouthPictures, CheeksLipsAndTongueAroundTheTeeth) {
    expectBaseline("soft-tissues", seenFrom(uncut(), {1.25, 0.62}, crown(), 60, 0, true));
}

TEST_F(MouthPictures, InMotion) {
    expectBaseline("mouth-motion", seenFrom(uncut(), {1.9, 0.8}, crown(), 30, 0, true), kMoving);
}

/// The other half of the jaw and the tongue would stand before the tooth.
TEST_F(MouthPictures, FromLingualTheWayToTheToothIsFree) {
    expectBaseline("mouth-lingual", seenFrom(uncut(), {-1.57, 0.1}, crown(), 24, 0, true));
}

TEST_F(MouthPictures, GumAroundTheNeck) {
    expectBaseline("gum", seenFrom(uncut(), {1.5, 0.15}, crown() - Vec3(0, 0, 6), 14));
}

TEST_F(MouthPictures, GumAndTeethInTheSpray) {
    expectBaseline("mouth-wet", seenFrom(uncut(), {1.9, 0.8}, crown(), 22, 1));
}

TEST_F(MouthPictures, ZonesOfDecayOnTheWallsOfACut) {
    CutModel piece = uncut();
    const CuttingTool tool{*RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 1.6, 8, 48)), 1};
    const Vec3 at = crown();
    for (const double x : {-0.9, 0.9}) {
        (void)piece.sweep(tool, {at + Vec3(x, 0, 3), Quat::Identity()}, {at + Vec3(x, 0, -1.2), Quat::Identity()});
    }
    piece.refreshSurface();
    expectBaseline("decay-zones", seenFrom(piece, {1.7, 1.1}, at, 7));
}

}  // namespace
}  // namespace tactooth
