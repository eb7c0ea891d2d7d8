// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bur that hovers and travels touches nothing, whatever the mouse does, and cuts nothing from the end of a press on:
// random aiming, with and without presses between, over each tooth of the whole mouth, each built-in tooth and each
// exercise, with a running bur in cut mode.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iostream>
#include <random>

#include "app/common/inspection.h"
#include "app/gui/input/viewport.h"
#include "assessment/exercise.h"
#include "devices/mouse/mouse_device.h"
#include "session/hands/instrument_poses.h"
#include "session/hands/mouse_surroundings.h"
#include "session/kernel/stepwise_session.h"
#include "session/model/session_bur.h"
#include "session/model/session_tooth.h"
#include "session/simulation/cut_events.h"
#include "support/servo_tick.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {
namespace {

constexpr ImageSize kPicture{900, 700};
constexpr double kFrame = 1.0 / 60;   // s
constexpr double kLongestStep = 0.1;  // s that the hand moves on in one frame, as in the window
constexpr int kTicksPerCut = 4;
constexpr double kLongestLeave = 3;  // s: a tool under an edge goes back as it came
constexpr double kHandStops = 0.08;  // s: the mouse's device follows its target within it
using test::kTick;

/// Where the mouse works.
struct Place {
    std::shared_ptr<CutModel> model;
    Box3 box;
    double mesialX = 1;
};

/// What has happened while the button was up.
struct Found {
    int contacts = 0;      // ticks that touch, after the tool had left
    double removed = 0;    // mm^3 that a bur has ground away
    int events = 0;        // but for pieces that fall when the bur is lifted
    double travelled = 0;  // mm
    int over = 0;          // frames with a tooth under the mouse
    int presses = 0, cuts = 0;
    int stuck = 0;            // frames in which a tool could not leave
    double longestLeave = 0;  // s from the end of a press until the tool was free
};

/// A session with a mouse that wanders at random over the picture, or draws one stroke.
class Wanderer {
public:
    /// `frame`: s from one step of the window to the next.
    Wanderer(Place place, const SessionBur& bur, unsigned seed, double frame = kFrame)
        : place_(std::move(place)),
          frame_(frame),
          bur_(bur),
          random_(seed),
          session_(place_.model, {bur.instrument, settings(), Placement::AtOnce}),
          hand_(place_.box, place_.mesialX),
          mouse_(hand_.pose()),
          events_(place_.model->tooth().materials()) {
        camera_.fit(crownBox(place_.box, 4), kPicture.aspect());
        tick_.contact.proxy = tick_.input.device = hand_.pose();
    }
    [[nodiscard]] MouseManipulator& hand() { return hand_; }

    /// `pressEvery`: frames from one press to the next, at least; 0: never.
    [[nodiscard]] Found wander(int frames, int pressEvery) {
        for (int frame = 0; frame < frames; ++frame) {
            show();
            if (frame % 240 == 0 && !hand_.isPressing()) turn();
            moveMouse(frame, pressEvery);
            move();
        }
        session_.finish(false);
        return found_;
    }

    /// One stroke for `seconds` from `from` to `to`, places of the tooth's frame as the dentist sees them, and then the
    /// button goes up.
    [[nodiscard]] Found stroke(const Vec3& from, const Vec3& to, double seconds) {
        const ViewDirection direction = dentistView(place_.mesialX);
        camera_.setView({direction.azimuth, direction.elevation});
        const Viewport view(camera_.camera(), kPicture);
        const Vec2 begin = *project(view.camera(), kPicture, from), end = *project(view.camera(), kPicture, to);
        for (const double until = time_ + 5 * slowness(); time_ < until;) {
            show();
            hand_.aim(view, begin, *hand_.surroundings().touchable);
            move();
        }
        before_ = ground();
        hand_.press(view, begin);
        for (const double began = time_; time_ < began + seconds;) {
            show();
            hand_.drag(view, begin + (time_ - began) / seconds * (end - begin));
            move();
        }
        release();
        for (const double until = time_ + 2 * longestLeave(); time_ < until;) {
            show();
            hand_.aim(view, end, *hand_.surroundings().touchable);
            move();
        }
        session_.finish(false);
        return found_;
    }

private:
    [[nodiscard]] HapticSettings settings() const {
        HapticSettings settings;
        settings.materials = MaterialTable(place_.model->tooth().materials());
        return settings;
    }

    /// Seconds of the session for one of the hand.
    [[nodiscard]] double slowness() const { return frame_ / std::min(frame_, kLongestStep); }
    [[nodiscard]] double longestLeave() const { return kLongestLeave * slowness(); }

    void show() { surroundings_.show(hand_, *place_.model, place_.model->surface(), bur_.instrument.shape); }
    void move() {
        hand_.advance(std::min(frame_, kLongestStep), tick_.contact.proxy.position, tick_.contact.depth);
        mouse_.moveTo({hand_.pose(), 0, 0, true});
        simulate();
    }

    void turn() {
        constexpr std::array kViews = {StandardView::Occlusal, StandardView::Buccal, StandardView::Lingual,
                                       StandardView::Mesial, StandardView::Distal};
        if (between(0, 1) < 0.2) {
            const ViewDirection view = dentistView(place_.mesialX);
            camera_.setView({view.azimuth, view.elevation});
        } else {
            camera_.setView(kViews[random_() % kViews.size()], place_.mesialX);
        }
    }

    void moveMouse(int frame, int pressEvery) {
        const Viewport view(camera_.camera(), kPicture);
        ++sincePress_;
        if (hand_.isPressing()) {
            constexpr int kLongestPress = 90;
            constexpr double kEnough = 0.02;  // mm^3
            pixel_ += 0.2 * step();
            if (sincePress_ > kLongestPress || ground() > before_ + kEnough) return release();
            return hand_.drag(view, pixel_);
        }
        if (frame % 47 == 0) pixel_ = Vec2(between(0, kPicture.width), between(0, kPicture.height));
        pixel_ += step();
        if (frame % 90 == 0) hand_.tilt(view, 5 * step());
        hand_.aim(view, pixel_, *hand_.surroundings().touchable);
        found_.over += hand_.landing() ? 1 : 0;
        if (pressEvery == 0 || sincePress_ < pressEvery || !hand_.landing()) return;
        hand_.press(view, pixel_);
        sincePress_ = 0;
        before_ = ground();
        ++found_.presses;
    }

    void release() {
        hand_.release();
        releasedAt_ = time_;
        found_.cuts += ground() > before_ ? 1 : 0;
        before_ = ground();
        isLeaving_ = true;
    }

    void simulate() {
        const bool isUp = !hand_.isPressing();
        for (const double end = time_ + frame_; time_ < end; time_ += kTick) {
            const Vec3 before = tick_.contact.proxy.position;
            tick_ = session_.step({mouse_.read(kTick).hand, 1, hand_.mayCut()}, kTick, time_);
            const std::size_t known = events_.all().size();
            events_.update(tick_.time, tick_, place_.model->loss());
            if (isUp) watch(before, known);
            if (++ticks_ % kTicksPerCut == 0) (void)session_.carve();
            session_.list();
        }
        if (!isUp) return;
        found_.removed = std::max(found_.removed, ground() - before_);
        found_.stuck += isLeaving_ && time_ > releasedAt_ + longestLeave() ? 1 : 0;
    }

    /// `known`: number of events before the tick.
    void watch(const Vec3& before, std::size_t known) {
        found_.travelled += (tick_.contact.proxy.position - before).norm();
        if (isLeaving_ && hand_.mayCut() && tick_.contact.triangles == 0) {
            isLeaving_ = false;
            found_.longestLeave = std::max(found_.longestLeave, time_ - releasedAt_);
        }
        if (!isLeaving_ && tick_.contact.triangles > 0 && found_.contacts++ == 0) {
            ADD_FAILURE() << "touches at " << time_ << " s: " << tick_.contact.proxy.position.transpose();
        }
        for (std::size_t i = known; i < events_.all().size(); ++i) {
            if (events_.all()[i].kind == CutEventKind::FragmentReleased) continue;
            if (isLeaving_ && time_ < releasedAt_ + kHandStops) continue;  // the end of the press
            ++found_.events;
            ADD_FAILURE() << cutEventName(events_.all()[i].kind) << " at " << time_ << " s";
        }
    }

    [[nodiscard]] double ground() const { return total(place_.model->loss().ground()); }
    [[nodiscard]] double between(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }
    [[nodiscard]] Vec2 step() {
        const double x = between(-12, 12);
        return {x, between(-12, 12)};
    }

    Place place_;
    double frame_;
    const SessionBur& bur_;
    std::mt19937 random_;
    StepwiseSession session_;
    MouseManipulator hand_;
    MouseSurroundings surroundings_;
    MouseDevice mouse_;
    OrbitCamera camera_;
    CutEvents events_;
    Vec2 pixel_ = Vec2(kPicture.width / 2.0, kPicture.height / 2.0);
    Tick tick_;
    Found found_;
    double time_ = 0, releasedAt_ = 0;
    double before_ = 0;  // ground away at the end of the last press, mm^3
    bool isLeaving_ = false;
    int ticks_ = 0;
    int sincePress_ = 0;  // frames
};

Place placeOf(const SessionTooth& tooth) { return {tooth.piece, tooth.box(), tooth.mesialX}; }

SessionBur anyBur(unsigned seed) {
    const auto burs = burCatalogue();
    std::mt19937 random(seed);
    return *makeSessionBur(burs[random() % burs.size()]);
}

void expectClear(const Found& found) {
    EXPECT_EQ(found.contacts, 0);
    EXPECT_EQ(found.events, 0);
    EXPECT_EQ(found.removed, 0);
    EXPECT_EQ(found.stuck, 0);
    std::cout << "[ presses  ] " << found.presses << ", cuts " << found.cuts << ", slowest to leave "
              << found.longestLeave << " s\n";
}

/// A minute over each of ten mouths: ten minutes in all.
class ClearHovering : public testing::TestWithParam<int> {};

TEST_P(ClearHovering, TouchesAndCutsNothing) {
    const auto tooth = makeSessionTooth(MouthChoice{.fdi = GetParam()});
    ASSERT_TRUE(tooth) << tooth.error().message();
    const auto seed = static_cast<unsigned>(GetParam());
    const SessionBur bur = anyBur(seed);
    const Found found = Wanderer(placeOf(*tooth), bur, seed).wander(60 * 60, 0);
    expectClear(found);
    EXPECT_EQ(total(tooth->piece->removed()), 0);
    EXPECT_GT(found.travelled, 300) << "mm: it went about";
    EXPECT_GT(found.over, 600) << "frames over a tooth";
}

INSTANTIATE_TEST_SUITE_P(InTenMouths, ClearHovering, testing::Values(11, 13, 15, 16, 27, 31, 33, 35, 36, 47));

constexpr int kFrames = 60 * 12, kPressEvery = 120;

class ClearTravelBetweenPresses : public testing::TestWithParam<int> {};

TEST_P(ClearTravelBetweenPresses, TouchesAndCutsNothingOnEachToothOfTheMouth) {
    const auto tooth = makeSessionTooth(MouthChoice{.fdi = GetParam()});
    ASSERT_TRUE(tooth) << tooth.error().message();
    const auto seed = static_cast<unsigned>(100 + GetParam());
    const SessionBur bur = anyBur(seed);
    const Found found = Wanderer(placeOf(*tooth), bur, seed).wander(kFrames, kPressEvery);
    expectClear(found);
    EXPECT_GT(found.presses, 0);
}

INSTANTIATE_TEST_SUITE_P(OnEachTooth, ClearTravelBetweenPresses,
                         testing::Values(11, 12, 13, 14, 15, 16, 17, 18, 21, 22, 23, 24, 25, 26, 27, 28, 31, 32, 33, 34,
                                         35, 36, 37, 38, 41, 42, 43, 44, 45, 46, 47, 48));

class ClearTravelOnBuiltinTeeth : public testing::TestWithParam<std::size_t> {};

TEST_P(ClearTravelOnBuiltinTeeth, TouchesAndCutsNothing) {
    const auto tooth = makeSessionTooth(kBuiltinTeeth.at(GetParam()));
    ASSERT_TRUE(tooth) << tooth.error().message();
    const auto seed = static_cast<unsigned>(200 + GetParam());
    const SessionBur bur = anyBur(seed);
    const Found found = Wanderer(placeOf(*tooth), bur, seed).wander(kFrames, kPressEvery);
    expectClear(found);
    EXPECT_GT(found.presses, 0);
}

INSTANTIATE_TEST_SUITE_P(OnEach, ClearTravelOnBuiltinTeeth, testing::Range<std::size_t>(0, kBuiltinTeeth.size()));

/// A stroke from the central fossa deep below a cusp: the bur cannot leave along its shaft. On a slow machine the
/// window steps twice a second.
class ClearTravelFromBelowACusp : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(ClearTravelFromBelowACusp, GoesBackAsItCame) {
    const auto& [frame, aside] = GetParam();
    const auto tooth = makeSessionTooth(MouthChoice{.fdi = 46});
    ASSERT_TRUE(tooth) << tooth.error().message();
    const SessionBur bur = *makeSessionBur(*findBur("4"));
    Wanderer wanderer(placeOf(*tooth), bur, 1, frame);
    wanderer.hand().depthControl().setDepth(2);
    const Vec3 fossa(0, 0, 5);
    const Found found = wanderer.stroke(fossa, fossa + Vec3(0, aside, 0), 12);
    expectClear(found);
    EXPECT_EQ(found.cuts, 1);
    EXPECT_GT(found.longestLeave, 0) << "it has left";
}

INSTANTIATE_TEST_SUITE_P(AtEachRate, ClearTravelFromBelowACusp,
                         testing::Combine(testing::Values(kFrame, 0.1, 0.5), testing::Values(-2.5, 2.5)));

/// Any stroke, with any bur and depth, at any rate.
class ClearTravelAfterAnyStroke : public testing::TestWithParam<unsigned> {};

TEST_P(ClearTravelAfterAnyStroke, TheBurComesOut) {
    const auto tooth = makeSessionTooth(kBuiltinTeeth.front());
    ASSERT_TRUE(tooth) << tooth.error().message();
    const SessionBur bur = anyBur(400 + GetParam());
    std::mt19937 random(GetParam());
    const auto between = [&random](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    const auto place = [&] {
        const double x = between(-3.5, 3.5), y = between(-3, 3);
        return Vec3(x, y, 5);
    };
    constexpr std::array kFrameTimes = {kFrame, 0.05, 0.1, 0.3};
    Wanderer wanderer(placeOf(*tooth), bur, GetParam(), kFrameTimes.at(random() % kFrameTimes.size()));
    wanderer.hand().depthControl().setDepth(between(0.5, 4));
    wanderer.hand().setPressDepth(between(0.3, 3));
    if (between(0, 1) < 0.3) wanderer.hand().setPressMode(PressMode::Force);
    const Vec3 from = place(), to = place();
    const Found found = wanderer.stroke(from, to, between(2, 10));
    expectClear(found);
    if (found.cuts > 0) {
        EXPECT_GT(found.longestLeave, 0) << "it has left";
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ClearTravelAfterAnyStroke, testing::Range(1U, 25U));

/// An exercise's tooth, as the window loads it.
Expected<SessionTooth> toothOf(const Exercise& exercise) {
    const auto& request = std::get<ToothRequest>(exercise.tooth);
    if (!exercise.inMouth) return makeSessionTooth(request, exercise.name, "");
    return makeSessionTooth(MouthChoice{.fdi = request.fdi, .lesion = request.lesion, .filling = request.filling});
}

class ClearTravelInExercises : public testing::TestWithParam<std::shared_ptr<const Exercise>> {};

TEST_P(ClearTravelInExercises, TouchesAndCutsNothing) {
    const Exercise& exercise = *GetParam();
    const auto tooth = toothOf(exercise);
    ASSERT_TRUE(tooth) << tooth.error().message();
    const auto seed = 300 + static_cast<unsigned>(exercise.id.size());
    const SessionBur bur = *makeSessionBur(*findBur(std::get<std::string>(exercise.bur)));
    Wanderer wanderer(placeOf(*tooth), bur, seed);
    if (const auto* const plan = std::get_if<PreparationPlan>(&exercise.ideal)) {
        wanderer.hand().alignShaft(plan->outward);
        wanderer.hand().depthControl().setDepth(plan->depth);
    }
    const Found found = wanderer.wander(kFrames, kPressEvery);
    expectClear(found);
    EXPECT_GT(found.presses, 0);
}

INSTANTIATE_TEST_SUITE_P(InEach, ClearTravelInExercises, testing::ValuesIn(exercises().begin(), exercises().end()),
                         [](const auto& one) {
                             std::string name = one.param->id;
                             std::ranges::replace_if(
                                 name, [](char c) { return !std::isalnum(c); }, '_');
                             return name;
                         });

}  // namespace
}  // namespace tactooth
