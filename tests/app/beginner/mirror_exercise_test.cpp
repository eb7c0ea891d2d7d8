// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exercise in the mirror, cut through the mirror: a hand at the mouse follows the images that the glass shows, by
// the pixels that the window would give to its HandPointer.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/common/inspection.h"
#include "app/gui/input/viewport.h"
#include "assessment/cavity_metrics.h"
#include "assessment/exercise.h"
#include "devices/mouse/mouse_device.h"
#include "instruments/mirror.h"
#include "session/control/surface_ray.h"
#include "session/hands/hand_pointer.h"
#include "session/hands/instrument_poses.h"
#include "session/kernel/stepwise_session.h"
#include "session/model/session_bur.h"
#include "session/model/session_tooth.h"
#include "session/simulation/cut_events.h"
#include "tooth/model/material_definition.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {
namespace {

constexpr ImageSize kPicture{900, 700};
constexpr double kFrame = 1.0 / 60;  // s
constexpr int kTicksPerCut = 4;

class MirrorExercise : public testing::Test {
protected:
    MirrorExercise()
        : exercise_(builtinExercise("mirror-26")),
          plan_(std::get<PreparationPlan>(exercise_->ideal)),
          bur_(*makeSessionBur(*findBur(std::get<std::string>(exercise_->bur)))) {
        const auto& request = std::get<ToothRequest>(exercise_->tooth);
        auto made =
            makeSessionTooth(MouthChoice{.fdi = request.fdi, .lesion = request.lesion, .filling = request.filling});
        EXPECT_TRUE(made);
        tooth_ = std::move(*made);
        const ViewDirection direction = chairViewOf(tooth_).view;
        OrbitCamera camera;
        camera.setView(OrbitCamera::Direction{direction.azimuth, direction.elevation});
        constexpr double kAbove = 13;  // mm, as ToothView::resetView
        camera.fit(crownBox(tooth_.box(), kAbove), kPicture.aspect());
        view_ = Viewport(camera.camera(), kPicture);
        glass_ = glassAt(makeMirror().disc, parkedMirror(tooth_.box(), directionToEye(direction), tooth_.mesialX));
    }
    [[nodiscard]] Vec2 imageOf(const Vec3& place) const {
        return *project(view_.camera(), kPicture, mirrorImage(glass_, place));
    }
    /// The images of the groove on the surface, in steps of a tenth of a millimetre or less.
    [[nodiscard]] std::vector<Vec2> groove() const {
        const auto outer = tooth_.piece->tooth().ownOuter();
        std::vector<Vec2> images;
        for (const BurPath& path : burPaths(plan_, tooth_.piece->tooth(), outer)) {
            for (const Vec3& place : path.places) {
                const Vec3 start = place + 20 * plan_.outward;
                const auto hit = firstHit({.base = outer}, {start, -plan_.outward});
                images.push_back(imageOf(hit ? Vec3(start - *hit * plan_.outward) : place));
            }
        }
        return images;
    }

    std::shared_ptr<const Exercise> exercise_;
    const PreparationPlan& plan_;
    SessionBur bur_;
    SessionTooth tooth_;
    Viewport view_;
    MirrorDisc glass_;
};

TEST_F(MirrorExercise, TheParkedMirrorShowsTheWholeGroove) {
    const auto mouth = tooth_.piece->contactSurface();
    const std::vector<Vec2> places = groove();
    ASSERT_GT(places.size(), 5U);
    for (const Vec2& pixel : places) {
        EXPECT_TRUE(showsGlass(view_, pixel, glass_, *mouth)) << pixel.transpose();
        const auto seen = firstSeen(*mouth, MirrorView(view_, glass_).rayThrough(pixel));
        ASSERT_TRUE(seen);
        EXPECT_FALSE(seen->isAdjacent) << "the gum or a neighbour is before it";
    }
}

TEST_F(MirrorExercise, AHandThatSeesTheMirrorAloneCutsTheGroove) {
    CutModel& model = *tooth_.piece;
    HapticSettings settings;
    settings.materials = MaterialTable(model.tooth().materials());
    StepwiseSession session(tooth_.piece, {bur_.instrument, settings, Placement::AtOnce});
    const auto uncut = model.tooth().ownOuter();
    MouseManipulator hand(tooth_.box(), tooth_.mesialX);
    hand.alignShaft(plan_.outward);
    hand.depthControl().setDepth(plan_.depth);
    hand.depthControl().setFloor(plan_.isFlat ? CavityFloor::Flat : CavityFloor::FollowsSurface);
    MouseDevice mouse(hand.pose());
    HandPointer pointer;
    CutEvents events(model.tooth().materials());
    Tick tick;
    tick.contact.proxy = tick.input.device = hand.pose();
    double time = 0;
    int ticks = 0;
    const auto letPass = [&] {
        hand.setSurroundings({model.contactSurface(), bur_.instrument.shape, uncut});
        hand.advance(kFrame, tick.contact.proxy.position, tick.contact.depth);
        mouse.moveTo({hand.pose(), 0, 0, true});
        for (const double end = time + kFrame; time < end; time += 0.001) {
            tick = session.step({mouse.read(0.001).hand, 1, true}, 0.001, time);
            events.update(tick.time, tick, model.loss());
            if (++ticks % kTicksPerCut == 0) (void)session.carve();
            session.list();
        }
    };
    hand.setSurroundings({model.contactSurface(), bur_.instrument.shape, uncut});
    std::vector<Vec2> way = groove();
    ASSERT_GT(way.size(), 5U);
    for (int i = 0; i < 90; ++i) {  // to where the first pixel points, and there
        pointer.aim(hand, {view_, glass_, *model.contactSurface()}, way.front());
        letPass();
    }
    ASSERT_TRUE(pointer.isInMirror());
    pointer.press(hand, {view_, glass_, *model.contactSurface()}, way.front());
    Vec2 at = way.front();
    constexpr double kSpeed = 25;  // pixels/s
    for (int stroke = 0; stroke < 6; ++stroke) {
        for (const Vec2& next : way) {
            while ((next - at).norm() > 1e-9) {
                at += (next - at).normalized() * std::min((next - at).norm(), kSpeed * kFrame);
                pointer.drag(hand, {view_, glass_, *model.contactSurface()}, at);
                letPass();
            }
        }
        for (int i = 0; i < 60; ++i) letPass();
        std::ranges::reverse(way);
    }
    hand.release();
    for (int i = 0; i < 60; ++i) letPass();
    session.finish(false);

    const auto ideal = idealShape(*exercise_, tooth_.piece->volume().tooth());
    ASSERT_TRUE(ideal);
    CavityMetrics metrics(std::make_shared<const SurfacePart>(*ideal), *uncut, cavityWalls(*ideal, *uncut));
    const CavityProgress cavity = metrics.of(*model.surface(), total(model.removed()));
    std::printf("mirror-26 through the mirror: cleared %.0f %%, over %.2f mm, Dice %.2f, %.0f s\n",
                100 * cavity.clearedFraction(), cavity.maxOverPreparation, cavity.dice(), time);
    EXPECT_GE(cavity.clearedFraction(), 0.8);
    EXPECT_LE(cavity.maxOverPreparation, 0.3);
    for (const CutEvent& event : events.all()) {
        EXPECT_NE(event.kind, CutEventKind::NeighbourTouched) << event.time << " s";
        EXPECT_NE(event.kind, CutEventKind::AdjacentCut) << event.time << " s";
        EXPECT_NE(event.kind, CutEventKind::PulpExposed) << event.time << " s";
    }
}

}  // namespace
}  // namespace tactooth
