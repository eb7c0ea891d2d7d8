// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/guided_tour.h"

#include <array>
#include <cmath>
#include <numbers>

#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/scene/clear_view.h"
#include "app/gui/scene/tooth_view.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr int kTickMs = 40;
constexpr double kStroke = 0.8;  // mm to each side
constexpr double kStrokesPerSecond = 0.5;

}  // namespace

GuidedTour::GuidedTour(SessionModel& model, ToothView& view, DrillBar& drill, DrivePanel& drive, QObject* parent)
    : QObject(parent), model_(model), view_(view), drill_(drill), drive_(drive) {
    steps_ = {{3, tr("Demonstration: the bur hovers where the mouse points"), &GuidedTour::aim, true},
              {4, tr("Left button: the bur presses; the gauge shows the force"), &GuidedTour::touch, true},
              {2, tr("Button up: the bur lifts"), &GuidedTour::lift, false},
              {7, tr("Cut and the pedal: the bur turns and removes what it presses on"), &GuidedTour::cut, true},
              {2, tr("Button up, pedal up"), &GuidedTour::lift, false},
              {3, tr("Undo takes the cut back. Now it is your turn"), &GuidedTour::undo, false}};
    connect(&timer_, &QTimer::timeout, this, &GuidedTour::advance);
}

void GuidedTour::start() {
    if (model_.runner() == nullptr || model_.isExamination()) return;  // it takes its cut back
    model_.manipulator().resetOrientation();
    view_.resetView();
    lookPastTheHandpiece();
    step_ = 0;
    beginStep();
    timer_.start(kTickMs);
}

/// Handpiece and cusps must not hide what the bur does.
void GuidedTour::lookPastTheHandpiece() {
    const auto tooth = model_.runner()->feed().surface();
    const auto& meshes = model_.instruments().meshes();
    Surface handpiece;
    if (view_.showsTurbine() && meshes) {
        handpiece.base = std::make_shared<const SurfacePart>(*meshes->handpieces.of(model_.haptics().spindle));
    }
    const Quat grip = model_.manipulator().pose().rotation;
    const std::array tools = {Pose{placeAt(-kStroke), grip}, Pose{placeAt(0), grip}, Pose{placeAt(kStroke), grip}};
    const Obstacles obstacles{*tooth, handpiece.base != nullptr ? &handpiece : nullptr};
    const ViewDirection view = clearView(obstacles, tools, dentistView(model_.mesialX()));
    OrbitCamera camera = view_.orbitCamera();
    camera.setView({view.azimuth, view.elevation});
    view_.setOrbitCamera(camera);
}

void GuidedTour::stop() {
    if (!isRunning()) return;
    timer_.stop();
    lift();
    drill_.touchAction()->trigger();
    emit ended();
}

void GuidedTour::beginStep() {
    time_ = 0;
    (this->*steps_[step_].begin)();
    emit stepExplained(steps_[step_].sentence);
}

void GuidedTour::advance() {
    time_ += 0.001 * kTickMs;
    if (time_ >= steps_[step_].seconds) {
        if (++step_ == steps_.size()) return stop();
        return beginStep();
    }
    if (!steps_[step_].strokes || model_.runner() == nullptr) return;
    const double aside = kStroke * std::sin(2 * std::numbers::pi * kStrokesPerSecond * time_);
    if (model_.manipulator().isPressing()) {
        model_.manipulator().drag(picture(), pixelAt(aside));
    } else {
        model_.manipulator().aim(picture(), pixelAt(aside), *model_.runner()->feed().surface());
    }
}

void GuidedTour::aim() { drill_.touchAction()->trigger(); }

void GuidedTour::touch() { model_.manipulator().press(picture(), pixelAt(0)); }

void GuidedTour::lift() {
    model_.releaseHand();
    drive_.setKeyDown(false);
}

void GuidedTour::cut() {
    drill_.cutAction()->trigger();
    drive_.setKeyDown(true);
    touch();
}

void GuidedTour::undo() { drill_.undoAction()->trigger(); }

Viewport GuidedTour::picture() const { return view_.viewport(); }

Vec3 GuidedTour::placeAt(double aside) const {
    constexpr double kAbove = 1;  // mm
    const Box3 box = model_.tooth()->box();
    const Vec3 above(box.center().x() - model_.mesialX() * aside, box.center().y(), box.max().z() + kAbove);
    const auto hit = firstHit(*model_.runner()->feed().surface(), {above, -Vec3::UnitZ()});
    return above - hit.value_or(kAbove) * Vec3::UnitZ();
}

Vec2 GuidedTour::pixelAt(double aside) const {
    const auto pixel = project(picture().camera(), picture().size(), placeAt(aside));
    return pixel.value_or(Vec2(picture().size().width / 2.0, picture().size().height / 2.0));
}

}  // namespace tactooth
