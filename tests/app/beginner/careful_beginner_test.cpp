// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a careful beginner reaches with the mouse in the built-in exercises. The hand sees the outline of the cavity,
// the landing ring and the depth number in the picture, and nothing else. The session has no threads, so it is as exact
// as a live one and faster.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "app/beginner/beginner_hand.h"
#include "app/common/inspection.h"
#include "app/gui/input/viewport.h"
#include "assessment/cavity_metrics.h"
#include "assessment/cavity_view.h"
#include "assessment/exercise.h"
#include "devices/mouse/mouse_device.h"
#include "session/hands/instrument_poses.h"
#include "session/kernel/stepwise_session.h"
#include "session/model/session_bur.h"
#include "session/model/tip_measure.h"
#include "session/simulation/cut_events.h"
#include "tooth/model/material_definition.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {
namespace {

constexpr ImageSize kPicture{900, 700};
constexpr double kFrame = 1.0 / 60;  // s
constexpr int kTicksPerCut = 4;
constexpr double kLongest = 240;  // s: a hand that is not done by then gives up

/// An exercise as the window has it after its start.
struct Scene {
    explicit Scene(const Exercise& task)
        : exercise(task), tooth(*exerciseTooth(task)), bur(*makeSessionBur(*findBur(std::get<std::string>(task.bur)))) {
        const auto ideal = idealShape(task, tooth);
        EXPECT_TRUE(ideal) << ideal.error().message();
        const auto outer = tooth->ownOuter();
        walls = cavityWalls(*ideal, *outer);
        target = std::make_shared<const SurfacePart>(*ideal);
    }
    const Exercise& exercise;
    std::shared_ptr<const LayeredTooth> tooth;
    std::shared_ptr<const SurfacePart> target;
    CavityWalls walls;
    SessionBur bur;
};

const PreparationPlan& planOf(const Exercise& exercise) { return std::get<PreparationPlan>(exercise.ideal); }

Viewport viewOf(const Scene& scene) {
    OrbitCamera camera;
    const ViewDirection direction = viewOnto(planOf(scene.exercise), *scene.tooth, 1);
    camera.setView(OrbitCamera::Direction{direction.azimuth, direction.elevation});
    camera.fit(crownBox(scene.tooth->ownBox(), 2), kPicture.aspect());
    return {camera.camera(), kPicture};
}

/// The longest loop of the rim in the picture.
std::vector<Vec2> outlineOf(const Scene& scene, const Viewport& view) {
    std::map<std::uint32_t, std::uint32_t> after;
    for (const auto& [from, to] : scene.walls.rim) after[from] = to;
    std::vector<std::uint32_t> longest;
    while (!after.empty()) {
        std::vector<std::uint32_t> loop;
        std::uint32_t at = after.begin()->first;
        while (after.contains(at)) {
            loop.push_back(at);
            const std::uint32_t next = after[at];
            after.erase(at);
            at = next;
        }
        if (loop.size() > longest.size()) longest = loop;
    }
    std::vector<Vec2> outline;
    for (const std::uint32_t vertex : longest) {
        outline.push_back(*project(view.camera(), view.size(), scene.walls.mesh.vertices[vertex].cast<double>()));
    }
    return outline;
}

struct Outcome {
    CavityProgress cavity;
    double seconds = 0;
    bool opensPulp = false;
};

/// `longest`: s, the most that the hand works.
Outcome cutBy(const Scene& scene, unsigned seed, PressMode mode, double longest = kLongest) {
    const PreparationPlan& plan = planOf(scene.exercise);
    const auto model = std::make_shared<CutModel>(scene.tooth, 0.05);
    HapticSettings settings;
    settings.materials = MaterialTable(scene.tooth->materials());
    StepwiseSession session(model, {scene.bur.instrument, settings, Placement::AtOnce});
    MouseManipulator hand(scene.tooth->ownBox(), 1);
    const auto uncut = scene.tooth->ownOuter();
    hand.setSurroundings({model->surface(), scene.bur.instrument.shape, uncut});
    hand.alignShaft(plan.outward);
    hand.setPressMode(mode);
    hand.depthControl().setDepth(plan.depth);
    hand.depthControl().setFloor(plan.isFlat ? CavityFloor::Flat : CavityFloor::FollowsSurface);
    if (plan.isFlat) hand.depthControl().setReference(floorReference(plan, *scene.tooth));
    MouseDevice mouse(hand.pose());

    const Viewport view = viewOf(scene);
    const std::vector<Vec2> outline = outlineOf(scene, view);
    const double pitch = 1 / ((*project(view.camera(), kPicture, Vec3(1, 0, scene.tooth->ownBox().max().z())) -
                               *project(view.camera(), kPicture, Vec3(0, 0, scene.tooth->ownBox().max().z())))
                                  .norm());
    std::mt19937 random(seed);
    const double eventPeriod = 1 / std::uniform_real_distribution<double>(30, 125)(random);
    test::BeginnerHand beginner(seed, plan.depth, pitch);
    Tick tick;
    tick.contact.proxy = tick.input.device = hand.pose();
    double time = 0, eventAt = 0;
    Outcome outcome;
    CutEvents events(scene.tooth->materials());
    bool isDown = false, isDone = false;
    double doneAt = longest;
    int ticks = 0;
    while (time < std::min(longest, doneAt + 1)) {
        while (eventAt <= time && !isDone) {
            eventAt += eventPeriod;
            test::SeenPicture seen;
            seen.outline = outline;
            const AimMark mark = aimMark(hand, HeadOutline(scene.bur), tick.contact.proxy);
            for (const AimPlace& place : mark.ring) seen.ring.push_back(*project(view.camera(), kPicture, place.at));
            if (mark.landing) seen.landing = *project(view.camera(), kPicture, *mark.landing);
            seen.depth = hand.depthControl().depthOf(tick.contact.proxy.position, hand.pressDirection());
            if (plan.isFlat)
                seen.depth =
                    plan.depth -
                    hand.depthControl().toFloor(tick.contact.proxy.position, hand.pressDirection()).value_or(0);
            const auto action = beginner.next(eventPeriod, seen);
            const bool wantsDown = action.button == test::BeginnerHand::Button::Down;
            if (wantsDown && !isDown) {
                hand.press(view, action.pixel);
            } else if (wantsDown) {
                hand.drag(view, action.pixel);
            } else if (isDown) {
                hand.release();
            } else {
                hand.aim(view, action.pixel, *model->surface());
            }
            isDown = wantsDown;
            if (action.isDone) isDone = true, doneAt = time;
        }
        hand.setSurroundings({model->surface(), scene.bur.instrument.shape, uncut});
        hand.advance(kFrame, tick.contact.proxy.position, tick.contact.depth);
        mouse.moveTo({hand.pose(), 0, 0, true});
        for (const double end = time + kFrame; time < end; time += 0.001) {
            tick = session.step({mouse.read(0.001).hand, 1, true}, 0.001, time);
            events.update(tick.time, tick, model->loss());
            if (++ticks % kTicksPerCut == 0) (void)session.carve();
            session.list();
        }
    }
    session.finish(false);
    outcome.seconds = isDone ? doneAt : longest;
    CavityMetrics metrics(scene.target, *uncut, scene.walls);
    outcome.cavity = metrics.of(*model->surface(), total(model->removed()));
    for (const CutEvent& event : events.all()) outcome.opensPulp |= event.kind == CutEventKind::PulpExposed;
    return outcome;
}

int seeds() {
    const char* const wanted = std::getenv("TACTOOTH_BEGINNERS");
    return wanted != nullptr ? std::max(1, std::atoi(wanted)) : 1;
}

/// What the hand has to reach in each exercise.
constexpr double kMostOver = 0.30, kLeastCleared = 0.90, kLeastDice = 0.85, kMostSeconds = 180;

class CarefulBeginner : public testing::TestWithParam<const char*> {};

TEST_P(CarefulBeginner, CutsTheCavityToItsDepth) {
    const Exercise& exercise = *builtinExercise(GetParam());
    const Scene scene(exercise);
    for (int seed = 1; seed <= seeds(); ++seed) {
        const Outcome outcome = cutBy(scene, static_cast<unsigned>(seed), PressMode::Depth);
        const CavityProgress& cavity = outcome.cavity;
        std::printf("%s, seed %d: over %.2f mm, cleared %.0f %%, Dice %.2f, %.0f s\n", exercise.name.c_str(), seed,
                    cavity.maxOverPreparation, 100 * cavity.clearedFraction(), cavity.dice(), outcome.seconds);
        EXPECT_LE(cavity.maxOverPreparation, kMostOver);
        EXPECT_GE(cavity.clearedFraction(), kLeastCleared);
        EXPECT_GE(cavity.dice(), kLeastDice);
        EXPECT_LE(outcome.seconds, kMostSeconds);
        EXPECT_FALSE(outcome.opensPulp);
    }
}

/// For comparison: the same hand with a steady force, in the first minute of the Class V cavity.
TEST(CarefulBeginnerByForce, CutsFarTooDeep) {
    const Exercise& exercise = *builtinExercise("class-5-13");
    const Scene scene(exercise);
    const Outcome outcome = cutBy(scene, 1, PressMode::Force, 60);
    std::printf("%s by force: over %.2f mm, Dice %.2f, %.0f s\n", exercise.name.c_str(),
                outcome.cavity.maxOverPreparation, outcome.cavity.dice(), outcome.seconds);
    EXPECT_GT(outcome.cavity.maxOverPreparation, 0.3);
}

INSTANTIATE_TEST_SUITE_P(InEveryExercise, CarefulBeginner, testing::Values("pit-46", "class-1-46", "class-5-13"));

}  // namespace
}  // namespace tactooth
