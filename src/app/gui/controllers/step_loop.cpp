// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/step_loop.h"

#include <algorithm>

namespace tactooth {
namespace {

constexpr int kStepMs = 16;        // 60 steps a second
constexpr int kRestMs = 40;        // at rest
constexpr int kRestAfter = 120;    // steps in which nothing has moved
constexpr double kMinSpeed = 1;    // rev/min: a spindle that runs down never quite stops
constexpr double kMinMove = 1e-4;  // mm, that counts as a motion
constexpr int kNumbersMs = 100;    // ten times a second
constexpr int kStatusMs = 1000;
constexpr int kStatusAtRestMs = 5000;  // each new text makes the desktop compose the whole window
constexpr double kLongestStep = 0.1;   // s: after a stall the hand moves on gently

void setInterval(QTimer& timer, int milliseconds) {
    if (timer.interval() != milliseconds) timer.setInterval(milliseconds);
}

}  // namespace

StepLoop::StepLoop(SessionModel& model) : model_(model) {
    connect(&stepTimer_, &QTimer::timeout, this, &StepLoop::step);
    connect(&numbersTimer_, &QTimer::timeout, this, &StepLoop::numbersDue);
    connect(&statusTimer_, &QTimer::timeout, this, &StepLoop::statusDue);
    stepTimer_.start(kStepMs);
    numbersTimer_.start(kNumbersMs);
    statusTimer_.start(kStatusMs);
}

void StepLoop::step() {
    const double elapsed = sinceStep_.isValid() ? static_cast<double>(sinceStep_.restart()) / 1000 : 0;
    if (!sinceStep_.isValid()) sinceStep_.start();
    const double dt = std::min(elapsed, kLongestStep);
    emit aboutToStep(dt);
    report(model_.step(dt));
    emit stepped();
    adaptInterval();
}

void StepLoop::report(const SessionModel::StepResult& result) {
    if (result.faultMessage) emit faultChanged(*result.faultMessage);
    if (result.heavyTick) emit overloaded(*result.heavyTick);
    if (result.recordingFault) emit recordingFailed(*result.recordingFault);
    if (result.recordingResumed) emit recordingResumed();
    if (result.newRunner) emit runnerStarted();
    if (result.newTooth) emit toothChanged();
}

bool StepLoop::isResting() const { return idleSteps_ > kRestAfter; }

void StepLoop::adaptInterval() {
    const Tick& newest = model_.log().newest();
    const Vec3& place = newest.contact.proxy.position;
    const bool isStill = (place - lastPlace_).norm() < kMinMove && newest.spindle.speedRpm < kMinSpeed && !busy_;
    lastPlace_ = place;
    idleSteps_ = isStill ? idleSteps_ + 1 : 0;
    setInterval(stepTimer_, isResting() ? kRestMs : kStepMs);
    setInterval(statusTimer_, isResting() ? kStatusAtRestMs : kStatusMs);
}

}  // namespace tactooth
