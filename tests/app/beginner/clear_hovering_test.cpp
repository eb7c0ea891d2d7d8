// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bur that hovers and travels touches nothing, whatever the mouse does: a minute of random aiming over each of ten
// teeth in the whole mouth, with a running bur in cut mode.
#include <gtest/gtest.h>

#include <random>

#include "app/common/inspection.h"
#include "app/gui/input/viewport.h"
#include "devices/mouse/mouse_device.h"
#include "session/hands/instrument_poses.h"
#include "session/hands/mouse_manipulator.h"
#include "session/kernel/stepwise_session.h"
#include "session/model/session_bur.h"
#include "session/model/session_tooth.h"
#include "session/simulation/cut_events.h"
#include "support/servo_tick.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {
namespace {

constexpr ImageSize kPicture{900, 700};
constexpr double kFrame = 1.0 / 60;  // s
using test::kTick;

class ClearHovering : public testing::TestWithParam<int> {};

TEST_P(ClearHovering, TouchesAndCutsNothing) {
    auto tooth = makeSessionTooth(MouthChoice{.fdi = GetParam()});
    ASSERT_TRUE(tooth) << tooth.error().message();
    const std::shared_ptr<CutModel> model = tooth->piece;
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    const auto burs = burCatalogue();
    const SessionBur bur = *makeSessionBur(burs[random() % burs.size()]);
    HapticSettings settings;
    settings.materials = MaterialTable(model->tooth().materials());
    StepwiseSession session(model, {bur.instrument, settings, Placement::AtOnce});
    MouseManipulator hand(tooth->box(), tooth->mesialX);
    const auto touchable = surrounded(model->surface(), model->surroundings());
    hand.setSurroundings({touchable, bur.instrument.shape, model->tooth().ownOuter()});
    MouseDevice mouse(hand.pose());
    OrbitCamera camera;
    camera.fit(crownBox(tooth->box(), 4), kPicture.aspect());

    constexpr std::array kViews = {StandardView::Occlusal, StandardView::Buccal, StandardView::Lingual,
                                   StandardView::Mesial, StandardView::Distal};
    std::uniform_real_distribution<double> x(0, kPicture.width), y(0, kPicture.height), step(-12, 12), part(0, 1);
    Vec2 pixel(kPicture.width / 2.0, kPicture.height / 2.0);
    CutEvents events(model->tooth().materials());
    Tick tick;
    tick.contact.proxy = tick.input.device = hand.pose();
    double time = 0, travelled = 0;
    int contacts = 0, over = 0;
    for (int frame = 0; frame < 60 * 60; ++frame) {
        if (frame % 240 == 0) {
            if (part(random) < 0.2) {
                const ViewDirection view = dentistView(tooth->mesialX);
                camera.setView({view.azimuth, view.elevation});
            } else {
                camera.setView(kViews[random() % kViews.size()], tooth->mesialX);
            }
        }
        const Viewport view(camera.camera(), kPicture);
        if (frame % 47 == 0) pixel = Vec2(x(random), y(random));
        pixel += Vec2(step(random), step(random));
        if (frame % 90 == 0) hand.tilt(view, 60 * Vec2(step(random), step(random)) / 12);
        hand.aim(view, pixel, *touchable);
        over += hand.landing() ? 1 : 0;
        hand.advance(kFrame, tick.contact.proxy.position, tick.contact.depth);
        mouse.moveTo({hand.pose(), 0, 0, true});
        for (const double end = time + kFrame; time < end; time += kTick) {
            const Vec3 before = tick.contact.proxy.position;
            tick = session.step({mouse.read(kTick).hand, 1, true}, kTick, time);
            travelled += (tick.contact.proxy.position - before).norm();
            if (tick.contact.triangles > 0 && contacts++ == 0) {
                ADD_FAILURE() << "touches at " << time << " s, frame " << frame << ": "
                              << tick.contact.proxy.position.transpose();
            }
            events.update(tick.time, tick, model->loss());
            session.list();
        }
        (void)session.carve();
    }
    session.finish(false);
    EXPECT_EQ(contacts, 0);
    EXPECT_EQ(total(model->removed()), 0);
    EXPECT_TRUE(events.all().empty());
    EXPECT_GT(travelled, 300) << "mm: it went about";
    EXPECT_GT(over, 600) << "frames over a tooth";
}

INSTANTIATE_TEST_SUITE_P(InTenMouths, ClearHovering, testing::Values(11, 13, 15, 16, 27, 31, 33, 35, 36, 47));

}  // namespace
}  // namespace tactooth
