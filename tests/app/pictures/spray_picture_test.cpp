// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bur at work, from the simulation to the picture, against stored pictures (tests/image/README.md).

#include "app/common/scene_builder.h"
#include "app/common/spin_blur.h"
#include "app/common/spray_particles.h"
#include "app/common/tooth_zones.h"
#include "image/molar_fixture.h"
#include "instruments/bur_shape.h"
#include "instruments/suction_tube.h"
#include "instruments/turbine.h"
#include "session/simulation/cut_model.h"
#include "session/simulation/pulp_opening.h"
#include "session/simulation/tooth_source.h"
#include "session/simulation/work_liquids.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kFrame = 0.016;  // s

/// A round bur that sinks into the molar; made once.
class SprayPictures : public test::MolarPictures {
protected:
    static void SetUpTestSuite() {
        MolarPictures::SetUpTestSuite();
        bur_ = makeBur(*findBur("4"), 3000).surface;
        auto cutting = makeCuttingTool(bur_);
        ASSERT_TRUE(cutting) << cutting.error().message();
        tool_.emplace(std::move(*cutting));
        turbine_ = std::make_shared<const TriangleMesh>(makeTurbine(6000));
    }
    static void TearDownTestSuite() {
        turbine_.reset();
        MolarPictures::TearDownTestSuite();
    }

    /// The contact of a bur that comes down from `above`.
    static Vec3 letDown(CutModel& piece, Vec3 above, const Quat& grip) {
        constexpr double kStep = 0.05;  // mm
        while (total(piece.removed()) == 0 && above.z() > 0) {
            const Pose before{above, grip};
            above.z() -= kStep;
            (void)piece.sweep(*tool_, before, {above, grip});
        }
        return above;
    }

    /// The scene after half a second of cutting.
    static Scene atWork(double water, bool suction) {
        CutModel piece(tooth_, 0.1);
        const Box3 box = tooth_->outer()->tree().box();
        const Quat grip = uprightGrip(mesialX_, 0.2);
        const Vec3 start = letDown(piece, Vec3(box.center().x() + 1, box.center().y(), box.max().z()), grip);
        SprayParticleSystem spray(tool_->envelope.maxRadius(), parkedSuction(box, mesialX_).position);
        SprayInput now{.toolInTooth = {start, grip},
                       .normal = Vec3::UnitZ(),
                       .speedRpm = 300000,
                       .water = water,
                       .suction = suction};
        for (int i = 0; i < 30; ++i) {
            const Pose before = now.toolInTooth;
            now.toolInTooth.position -= Vec3(0, 0, 0.02);
            (void)piece.sweep(*tool_, before, now.toolInTooth);
            now.ground = piece.loss().ground();
            spray.advance(now, kFrame);
        }
        piece.refreshSurface();
        SceneContents contents;
        contents.tooth = piece.surface();
        contents.tool = ShownTool{.bur = std::make_shared<const TriangleMesh>(bur_),
                                  .turbine = turbine_,
                                  .toolInTooth = now.toolInTooth,
                                  .speedRpm = now.speedRpm,
                                  .blurred = std::make_shared<const TriangleMesh>(spinEnvelopeMesh(tool_->envelope))};
        if (suction) {
            contents.suction =
                ShownSuction{std::make_shared<const TriangleMesh>(makeSuctionTube()), parkedSuction(box, mesialX_)};
        }
        contents.flying = particlesOf(spray.particles(), contents.materials);
        OrbitCamera camera;
        camera.setView(mesialX_ < 0 ? mirroredInX({1.9, 0.6}) : OrbitCamera::Direction{1.9, 0.6});
        const Vec3 middle = start + Vec3(0, 0, 2);
        camera.fit(Box3(middle.array() - 5, middle.array() + 5), test::kTestSize.aspect());
        contents.camera = camera.camera();
        return makeScene(contents);
    }

    /// The molar in the appearances of its zones, seen from above, without instruments. `at`: the middle of the
    /// picture.
    static Scene closeUp(const CutModel& piece, const Vec3& at, const SurfaceLiquids& liquids) {
        SceneContents contents;
        contents.tooth = piece.surface();
        contents.zones = toothZones(*tooth_, contents.materials);
        contents.liquids = liquids;
        OrbitCamera camera;
        camera.setView({1.5, 1.45});
        camera.fit(Box3(at.array() - 2, at.array() + 2), test::kTestSize.aspect());
        contents.camera = camera.camera();
        return makeScene(contents);
    }
    /// A slot, 2 mm wide and 4.4 mm long, whose floor is `depth` mm below the cusps. Returns the middle of the floor.
    static Vec3 sink(CutModel& piece, double depth) {
        const CuttingTool tool{*RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 1, 9, 48)), 1};
        const Box3 box = tooth_->outer()->tree().box();
        const Vec3 floor(box.center().x(), box.center().y(), box.max().z() - depth);
        (void)piece.sweep(tool, {floor - Vec3(1.2, 0, 0), Quat::Identity()},
                          {floor + Vec3(1.2, 0, 0), Quat::Identity()});
        piece.refreshSurface();
        return floor;
    }
    /// Sinks the slot until the pulp lies open. Returns the middle of the floor, and the opening.
    static std::pair<Vec3, Vec3> openPulp(CutModel& piece) {
        for (double depth = 4; depth < 9; depth += 0.25) {
            const Vec3 floor = sink(piece, depth);
            if (const auto opening = nearestPulp(*piece.surface(), tooth_->materials(), floor))
                return {floor, *opening};
        }
        ADD_FAILURE() << "no pulp";
        return {};
    }
    static SurfaceLiquids shown(const WorkLiquids& of) {
        return {of.spot(), of.water(), of.slurry(), of.opening(), of.blood()};
    }
    static Scene handpieceFrom(OrbitCamera::Direction direction, const Box3& part) {
        SceneContents contents;
        contents.tool =
            ShownTool{.bur = std::make_shared<const TriangleMesh>(bur_), .turbine = turbine_, .toolInTooth = {}};
        OrbitCamera camera;
        camera.setView(direction);
        camera.fit(part, test::kTestSize.aspect());
        contents.camera = camera.camera();
        return makeScene(contents);
    }

    static inline TriangleMesh bur_;
    static inline std::optional<CuttingTool> tool_;
    static inline std::shared_ptr<const TriangleMesh> turbine_;
};

TEST_F(SprayPictures, ABurAtWorkInItsSpray) { expectBaseline("at-work", atWork(1, false)); }

TEST_F(SprayPictures, ABurThatCutsDryThrowsDust) { expectBaseline("at-work-dry", atWork(0, false)); }

TEST_F(SprayPictures, TheSuctionTubeDrawsTheMistAway) { expectBaseline("at-work-suction", atWork(1, true)); }

TEST_F(SprayPictures, CutEnamelIsChalkyAndCutDentinGlossy) {
    CutModel piece(tooth_, 0.1);
    const Vec3 floor = sink(piece, 4);
    expectBaseline("cut-tissues", closeUp(piece, floor + Vec3(0, 0, 1.5), {}));
}

TEST_F(SprayPictures, AnOpenedPulpBleedsOverTheFloor) {
    CutModel piece(tooth_, 0.1);
    const auto [floor, opening] = openPulp(piece);
    WorkLiquids liquids;
    liquids.advance({}, opening, 5);
    EXPECT_GT(liquids.blood(), 0.9 * WorkLiquids::kBloodReach);
    expectBaseline("pulp-bleeding", closeUp(piece, floor + Vec3(0, 0, 1.5), shown(liquids)));
    SprayInput spray{.toolInTooth = {floor, Quat::Identity()}, .water = 1};
    for (int i = 0; i < 125; ++i) liquids.advance(spray, opening, kFrame);
    expectBaseline("pulp-rinsed", closeUp(piece, floor + Vec3(0, 0, 1.5), shown(liquids)));
}

TEST_F(SprayPictures, SlurryAroundTheBurAndAFilmOfWater) {
    CutModel piece(tooth_, 0.1);
    const Vec3 floor = sink(piece, 4);
    WorkLiquids liquids;
    SprayInput spray{.toolInTooth = {floor, Quat::Identity()}, .water = 1};
    for (int i = 0; i < 60; ++i) {
        spray.ground[0] += 0.02;
        liquids.advance(spray, std::nullopt, kFrame);
    }
    expectBaseline("slurry", closeUp(piece, floor + Vec3(0, 0, 1.5), shown(liquids)));
    for (int i = 0; i < 250; ++i) liquids.advance(spray, std::nullopt, kFrame);
    expectBaseline("water-film", closeUp(piece, floor + Vec3(0, 0, 1.5), shown(liquids)));
}

TEST_F(SprayPictures, TheHandpieceIsBrushedAndKnurled) {
    expectBaseline("handle", handpieceFrom({1.3, 0.35}, Box3(Vec3(26, -6, 20), Vec3(56, 6, 34))));
}

TEST_F(SprayPictures, TheFaceOfTheHeadHasSprayHolesAndALight) {
    expectBaseline("head-face", handpieceFrom({1.9, -0.75}, Box3(Vec3(-5, -5, 5), Vec3(5, 5, 14))));
}

TEST_F(SprayPictures, InMotion) {
    CutModel piece(tooth_, 0.1);
    const Vec3 floor = sink(piece, 4);
    expectBaseline("motion", closeUp(piece, floor + Vec3(0, 0, 1.5), {.spot = floor, .water = 1, .slurry = 0.5}),
                   kMoving);
}

}  // namespace
}  // namespace tactooth
