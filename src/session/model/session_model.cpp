// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_model.h"

#include <utility>
#include <vector>

#include "haptics/overload_check.h"
#include "session/audio/tick_sound.h"
#include "session/model/instrument_poses.h"

namespace tactooth {
namespace {

const Box3 kNoTooth(Vec3(-5, -5, -5), Vec3(5, 5, 5));  // mm; the hand starts above it while there is no tooth

}  // namespace

SessionModel::SessionModel(SoundOutput& sound, const TaskExecutor& executor)
    : sound_(sound), manipulator_(kNoTooth, 1), devices_(manipulator_.pose()), instruments_(executor) {}

void SessionModel::install(SessionTooth tooth) {
    tooth_ = std::move(tooth);
    resetManipulator();
    haptics_.materials = MaterialTable(tooth_->piece->tooth().materials());
    if (tooth_->bur) bur_ = tooth_->bur;
    needsSimulator_ = isToothNew_ = true;
}

/// The hand starts above the tooth again; its press depth stays.
void SessionModel::resetManipulator() {
    const double pressDepth = manipulator_.pressDepth();
    manipulator_ = MouseManipulator(tooth_ ? tooth_->box() : kNoTooth, handleX(*this));
    manipulator_.setPressDepth(pressDepth);
}

void SessionModel::install(SessionBur bur) {
    bur_ = std::move(bur);
    needsSimulator_ = true;
}

void SessionModel::install(DeviceSlot slot, std::unique_ptr<HapticDevice> device) {
    const HapticDevice* const before = slot == DeviceSlot::First ? devices_.first() : devices_.second();
    if (device == nullptr && before == nullptr) return;
    simulator_.reset();  // it uses the device before
    devices_.set(slot, std::move(device));
    needsSimulator_ = true;
}

void SessionModel::setSpindle(const SpindlePreset& spindle) {
    haptics_.spindle = spindle;
    needsSimulator_ = true;
}

void SessionModel::setHand(const HandSettings& hand) {
    const HandSettings before = std::exchange(hand_, hand);
    if (hand.rate != before.rate) needsSimulator_ = true;
    if (hand.leftHanded == before.leftHanded) return;
    resetManipulator();
    if (devices_.first() != nullptr) needsSimulator_ = true;  // the device is registered anew
}

void SessionModel::setPaused(bool paused) {
    if (std::exchange(paused_, paused) == paused) return;
    simulator_.reset();
    needsSimulator_ = true;
}

void SessionModel::setCutting(bool cutting) {
    const bool chosenByButton = log_.newest().cutting != controls.cutting;
    controls.cutting = cutting != (devices_.first() != nullptr && chosenByButton);
}

void SessionModel::resetTooth() {
    if (simulator_ == nullptr) return;
    simulator_->requestReset();
    log_.clearEvents(haptics_.materials.registry());
}

std::optional<WorkspaceFit> SessionModel::fit() const {
    if (!tooth_) return std::nullopt;
    return devices_.fit(handWorkspace(tooth_->box()), deviceRotation(mesialX()));
}

double SessionModel::motionScaling() const {
    if (devices_.first() == nullptr || devices_.first()->info().isInToothFrame) return 1;
    return hand_.autoScaling ? fit().value_or(WorkspaceFit()).motionScaling : controls.motionScaling;
}

std::optional<DeviceRegistration> SessionModel::registration() const {
    return devices_.registration(manipulator_.pose(), handWorkspace(tooth_->box()), deviceRotation(mesialX()),
                                 hand_.autoScaling);
}

void SessionModel::startSimulator() {
    needsSimulator_ = false;
    manipulator_.release();
    devices_.moveMouse(manipulator_.pose());
    simulator_.reset();  // its threads end before the new ones begin: they share the cut model and the device
    simulator_ = std::make_unique<Simulator>(
        tooth_->piece, bur_->instrument, haptics_, devices_.active(),
        [this, tickSound = TickSound(haptics_.spindle, haptics_.materials, bur_->instrument.edge)](const Tick& tick) {
            DrillSoundState heard = tickSound.at(tick);
            instruments_.muteIdle(heard);
            sound_.publish(heard);
        },
        hand_.rate, registration(), devices_.second(), motionScaling());
    reportedOverload_ = false;
    Tick start;
    start.cutting = controls.cutting;
    start.proxy = start.hand = manipulator_.pose();
    log_.restart(start);
    animation_.restart(bur_->instrument.cutting.envelope.maxRadius(),
                       parkedSuction(tooth_->box(), tooth_->mesialX).position);
}

void SessionModel::reportOverload(StepResult& stepResult) {
    if (reportedOverload_ || !isOverloaded(simulator_->timing(), hand_.rate)) return;
    reportedOverload_ = true;
    stepResult.heavyTick = tickP99(simulator_->timing());
}

SimulatorControls SessionModel::currentControls() const {
    SimulatorControls now = controls;
    now.motionScaling = motionScaling();
    now.clutch = devices_.first() != nullptr && controls.clutch;
    return now;
}

SessionModel::StepResult SessionModel::step(double dt) {
    StepResult stepResult;
    instruments_.poll();
    if (needsSimulator_ && !paused_ && tooth_ && bur_) {
        startSimulator();
        stepResult.newSimulator = true;
        stepResult.newTooth = std::exchange(isToothNew_, false);
        if (stepResult.newTooth) log_.clearEvents(haptics_.materials.registry());
    }
    if (simulator_ == nullptr) {
        fetched_.clear();
        log_.record(fetched_, {});
        return stepResult;
    }
    simulator_->fetchTicks(fetched_);
    log_.record(fetched_, simulator_->loss());
    stepResult.faultMessage = devices_.changedFault();
    reportOverload(stepResult);
    const Tick& newest = log_.newest();
    manipulator_.advance(dt, newest.proxy.position, newest.depth);
    devices_.moveMouse(manipulator_.pose());
    simulator_->setControls(currentControls());
    animation_.advance(newest, instruments_.water(), instruments_.suction(), simulator_->loss().ground(), dt);
    return stepResult;
}

std::shared_ptr<const Surface> touchableSurface(const SessionModel& model) {
    return surrounded(model.simulator()->surface(), model.tooth()->piece->surroundings());
}

double handleX(const SessionModel& model) { return model.hand().leftHanded ? -model.mesialX() : model.mesialX(); }

}  // namespace tactooth
