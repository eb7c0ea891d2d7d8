// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bur at work, from the simulation to the picture, against stored pictures (tests/image/README.md).

#include "app/common/scene_builder.h"
#include "app/common/spin_blur.h"
#include "app/common/spray_particles.h"
#include "image/molar_fixture.h"
#include "instruments/bur_shape.h"
#include "instruments/suction_tube.h"
#include "instruments/turbine.h"
#include "session/simulation/cut_model.h"
#include "session/simulation/tooth_source.h"

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

private:
    static inline TriangleMesh bur_;
    static inline std::optional<CuttingTool> tool_;
    static inline std::shared_ptr<const TriangleMesh> turbine_;
};

TEST_F(SprayPictures, ABurAtWorkInItsSpray) { expectBaseline("at-work", atWork(1, false)); }

TEST_F(SprayPictures, ABurThatCutsDryThrowsDust) { expectBaseline("at-work-dry", atWork(0, false)); }

TEST_F(SprayPictures, TheSuctionTubeDrawsTheMistAway) { expectBaseline("at-work-suction", atWork(1, true)); }

}  // namespace
}  // namespace tactooth
