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

GuidedTour::GuidedTour(Workbench& bench, ToothView& view, DrillBar& drill, DrivePanel& drive, QObject* parent)
    : QObject(parent), bench_(bench), view_(view), drill_(drill), drive_(drive) {
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
    if (bench_.simulator() == nullptr) return;
    view_.lookAsUsual();
    view_.fit();
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
    emit says(steps_[step_].sentence);
}

void GuidedTour::advance() {
    time_ += 0.001 * kTickMs;
    if (time_ >= steps_[step_].seconds) {
        if (++step_ == steps_.size()) return stop();
        return beginStep();
    }
    if (!steps_[step_].strokes || bench_.simulator() == nullptr) return;
    const double aside = kStroke * std::sin(2 * std::numbers::pi * kStrokesPerSecond * time_);
    if (bench_.hand().isPressing()) {
        bench_.hand().drag(picture(), pixelAt(aside));
    } else {
        bench_.hand().aim(picture(), pixelAt(aside), *bench_.simulator()->surface());
    }
}

void GuidedTour::aim() { drill_.touchAction()->trigger(); }

void GuidedTour::touch() { bench_.hand().press(picture(), pixelAt(0)); }

void GuidedTour::lift() {
    bench_.hand().release();
    drive_.setKeyDown(false);
}

void GuidedTour::cut() {
    drill_.cutAction()->trigger();
    drive_.setKeyDown(true);
    touch();
}

void GuidedTour::undo() { drill_.undoAction()->trigger(); }

PointedPicture GuidedTour::picture() const { return view_.pointedPicture(); }

Vec2 GuidedTour::pixelAt(double aside) const {
    const Box3 box = bench_.tooth()->box();
    const Vec3 fossa(box.center().x() - bench_.mesialX() * aside, box.center().y(), box.max().z() - kBelowTop);
    const auto pixel = project(picture().camera, picture().size, fossa);
    return pixel.value_or(Vec2(picture().size.width / 2.0, picture().size.height / 2.0));
}

}  // namespace tactooth
