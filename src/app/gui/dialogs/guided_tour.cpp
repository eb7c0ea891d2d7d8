// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/guided_tour.h"

#include <cmath>
#include <numbers>

#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/scene/tooth_view.h"

namespace tactooth {
namespace {

constexpr int kTickMs = 40;
constexpr double kStroke = 0.8;  // mm to each side
constexpr double kStrokesPerSecond = 0.5;
constexpr double kBelowTop = 2.5;  // mm from the cusps down to the fossa of a molar

}  // namespace

GuidedTour::GuidedTour(SessionModel& model, ToothView& view, DrillBar& drill, DrivePanel& drive, QObject* parent)
    : QObject(parent), model_(model), view_(view), drill_(drill), drive_(drive) {
    steps_ = {
        {3, tr("Demonstration: the bur hovers where the mouse points"), &GuidedTour::aim, true},
        {4, tr("Left button: the bur presses; the gauge shows the force"), &GuidedTour::touch, true},
        {2, tr("Button up: the bur lifts"), &GuidedTour::lift, false},
        {7, tr("Cut (C) and the pedal (space): the bur turns and removes what it presses on"), &GuidedTour::cut, true},
        {2, tr("Button up, pedal up"), &GuidedTour::lift, false},
        {3, tr("Ctrl+Z takes the cut back. Now it is your turn"), &GuidedTour::undo, false}};
    connect(&timer_, &QTimer::timeout, this, &GuidedTour::advance);
}

void GuidedTour::start() {
    if (model_.runner() == nullptr) return;
    view_.resetView();
    step_ = 0;
    beginStep();
    timer_.start(kTickMs);
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
    model_.manipulator().release();
    drive_.setKeyDown(false);
}

void GuidedTour::cut() {
    drill_.cutAction()->trigger();
    drive_.setKeyDown(true);
    touch();
}

void GuidedTour::undo() { drill_.undoAction()->trigger(); }

Viewport GuidedTour::picture() const { return view_.viewport(); }

Vec2 GuidedTour::pixelAt(double aside) const {
    const Box3 box = model_.tooth()->box();
    const Vec3 fossa(box.center().x() - model_.mesialX() * aside, box.center().y(), box.max().z() - kBelowTop);
    const auto pixel = project(picture().camera(), picture().size(), fossa);
    return pixel.value_or(Vec2(picture().size().width / 2.0, picture().size().height / 2.0));
}

}  // namespace tactooth
