// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/session_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/common/spray_particles.h"
#include "haptics/overload_check.h"
#include "session/audio/tick_sound.h"

namespace tactooth {
namespace {

const Box3 kNoTooth(Vec3(-5, -5, -5), Vec3(5, 5, 5));       // where the hand rests before there is a tooth, mm
constexpr float kBreath = 0.6F, kWetness = 0.5F;            // share of the glass, 0..1: one still sees the crown in it
constexpr double kEyeAzimuth = 1.25, kEyeElevation = 0.62;  // rad, for a tooth with +x mesial

}  // namespace

SessionModel::SessionModel(SoundOutput& sound) : sound_(sound), manipulator_(kNoTooth, 1), mouse_(manipulator_.pose()) {
    pendingInstruments_.start([] { return Expected<SessionInstruments>(makeSessionInstruments()); });
}

SessionModel::~SessionModel() = default;

void SessionModel::install(SessionTooth tooth) {
    tooth_ = std::move(tooth);
    readManipulator();
    settings_.materials = tooth_->materials.value_or(MaterialTable());
    if (tooth_->bur) bur_ = tooth_->bur;
    simulatorIsOld_ = toothIsNew_ = true;
}

/// A fresh hand over the tooth, that presses as the one before.
void SessionModel::readManipulator() {
    const double pressDepth = manipulator_.pressDepth();
    manipulator_ = MouseManipulator(tooth_ ? tooth_->box() : kNoTooth, handleX());
    manipulator_.setPressDepth(pressDepth);
}

void SessionModel::install(SessionBur bur) {
    bur_ = std::move(bur);
    simulatorIsOld_ = true;
}

void SessionModel::setSpindle(const SpindlePreset& spindle) {
    settings_.spindle = spindle;
    simulatorIsOld_ = true;
}

void SessionModel::setRate(double rateHz) {
    if (rateHz == std::exchange(rate_, rateHz)) return;
    simulatorIsOld_ = true;
}

void SessionModel::install(std::unique_ptr<HapticDevice> device) {
    simulator_.reset();  // it uses the old one
    device_ = std::move(device);
    simulatorIsOld_ = true;
}

void SessionModel::useMouse() {
    simulator_.reset();  // it uses the device
    device_.reset();
    simulatorIsOld_ = true;
}

void SessionModel::setLeftHanded(bool leftHanded) {
    if (leftHanded == std::exchange(leftHanded_, leftHanded)) return;
    readManipulator();
    if (device_) simulatorIsOld_ = true;  // the hand takes the tool anew
}

void SessionModel::setCutting(bool cutting) {
    const bool chosenByButton = newest_.cutting != controls.cutting;
    controls.cutting = cutting != (device_ && chosenByButton);
}

void SessionModel::installSecond(std::unique_ptr<HapticDevice> device) {
    if (device == nullptr && second_ == nullptr) return;
    simulator_.reset();  // it may use an old one
    second_ = std::move(device);
    simulatorIsOld_ = true;
}

void SessionModel::reportDeviceTrouble(StepResult& stepResult) {
    const Message* faultMessage = device_ ? device_->faultMessage() : nullptr;
    if (faultMessage == nullptr && second_) faultMessage = second_->faultMessage();
    if (faultMessage != std::exchange(reportedTrouble_, faultMessage)) stepResult.faultMessage = faultMessage;
    if (reportedHeavy_ || !isOverloaded(simulator_->timing(), rate_)) return;
    reportedHeavy_ = true;  // once for each tooth, bur and device
    stepResult.heavyTick = tickP99(simulator_->timing());
}

void SessionModel::collectFinishedTasks(StepResult& stepResult) {
    if (auto tooth = pendingTooth_.poll()) {
        if (*tooth) {
            install(std::move(**tooth));
        } else {
            stepResult.failure = tooth->error();
        }
    }
    if (auto bur = pendingBur_.poll()) {
        if (*bur) {
            install(std::move(**bur));
        } else {
            stepResult.failure = bur->error();
        }
    }
    if (auto instruments = pendingInstruments_.poll()) {
        around_ = std::move(**instruments);
        replaceMirror(*around_, mirror_.diameter);
    }
}

/// From a device's frame into the tooth's: its "away" is the way that one looks at the tooth.
Quat SessionModel::manipulatorRotation() const {
    return Quat(Eigen::AngleAxisd(defaultView().azimuth + std::numbers::pi / 2, Vec3::UnitZ()));
}

/// All that a hand should reach with the tool.
Box3 SessionModel::reached() const {
    const Vec3 around = Vec3::Constant(MouseManipulator::kWorkspaceMargin);
    return {tooth_->box().min() - around, tooth_->box().max() + around};
}

std::optional<DeviceRegistration> SessionModel::registration() const {
    if (!device_ || device_->info().isInToothFrame) return {};
    const std::optional<Vec3>& workspaceCentre = device_->info().workspaceCentre;
    if (!autoScaling_ || !workspaceCentre) return DeviceRegistration{manipulator_.pose(), manipulatorRotation()};
    return DeviceRegistration{
        {reached().center(), manipulator_.pose().rotation}, manipulatorRotation(), workspaceCentre};
}

std::optional<WorkspaceFit> SessionModel::fit() const {
    std::optional<WorkspaceFit> fit;
    if (!tooth_ || !device_) return fit;
    const Vec3 size = sizeInDeviceFrame(reached().sizes(), manipulatorRotation());
    for (const HapticDevice* const device : {device_.get(), second_.get()}) {
        if (device == nullptr || device->info().workspace.isZero()) continue;
        const WorkspaceFit one = fitWorkspace(device->info().workspace, size);
        fit =
            fit ? WorkspaceFit{std::min(fit->motionScaling, one.motionScaling), fit->coversBox && one.coversBox} : one;
    }
    return fit;
}

double SessionModel::motionScaling() const {
    if (!device_ || device_->info().isInToothFrame) return 1;
    return autoScaling_ ? fit().value_or(WorkspaceFit()).motionScaling : controls.motionScaling;
}

void SessionModel::startSimulator(StepResult& stepResult) {
    simulatorIsOld_ = false;
    manipulator_.release();
    mouse_.moveTo({manipulator_.pose(), 0, 0, true});
    simulator_.reset();  // its threads end before the new one's begin: they share the work piece and the device
    HapticDevice& device = device_ ? *device_ : mouse_;
    simulator_ = std::make_unique<Simulator>(
        tooth_->piece, bur_->instrument, settings_, device,
        [this, settings = settings_, edge = bur_->instrument.edge](const Tick& tick) {
            DrillSoundState heard = soundOf(tick, settings.spindle, settings.materials, edge);
            if (!water_) heard.water = 0;
            if (!suction_) heard.suction = 0;
            sound_.publish(heard);
        },
        rate_, registration(), second_.get(), motionScaling());
    reportedHeavy_ = false;
    timeBefore_ += newest_.time;
    newest_ = Tick();
    newest_.cutting = controls.cutting;
    newest_.proxy = newest_.hand = manipulator_.pose();
    spray_ = SprayParticleSystem(bur_->instrument.cutting.envelope.maxRadius(),
                                 parkedSuction(tooth_->box(), tooth_->mesialX).position);
    stepResult.newSimulator = true;
}

void SessionModel::beginEvents() {
    events_ = {};
    timeBefore_ = -newest_.time;
}

void SessionModel::resetTooth() {
    if (simulator_ == nullptr) return;
    simulator_->requestReset();
    beginEvents();
}

double SessionModel::workSeconds() const {
    const std::vector<CutEvent>& events = events_.all();
    return events.empty() ? 0 : timeBefore_ + newest_.time - events.front().time;
}

void SessionModel::watchTicks() {
    const ToothLoss loss = simulator_->loss();
    for (const Tick& tick : ticks_) events_.update(timeBefore_ + tick.time, tick, loss);
}

SessionModel::StepResult SessionModel::step(double dt) {
    StepResult stepResult;
    collectFinishedTasks(stepResult);
    ticks_.clear();
    if (simulatorIsOld_ && tooth_ && bur_) {
        startSimulator(stepResult);
        stepResult.newTooth = std::exchange(toothIsNew_, false);
        if (stepResult.newTooth) beginEvents();
    }
    if (simulator_ == nullptr) return stepResult;
    simulator_->fetchTicks(ticks_);
    if (!ticks_.empty()) newest_ = ticks_.back();
    watchTicks();
    reportDeviceTrouble(stepResult);
    manipulator_.advance(dt, newest_.proxy.position, newest_.depth);
    mouse_.moveTo({manipulator_.pose(), 0, 0, true});
    SimulatorControls now = controls;
    now.motionScaling = motionScaling();
    now.clutch = device_ && controls.clutch;
    simulator_->setControls(now);
    spin_ = std::remainder(spin_ + newest_.speedRpm / 60 * 2 * std::numbers::pi * dt, 2 * std::numbers::pi);
    spray(dt);
    return stepResult;
}

void SessionModel::setMirror(double diameter, bool fogged, bool wet) {
    const bool isAnother = diameter != mirror_.diameter;
    mirror_ = {diameter, fogged, wet};
    if (isAnother && around_) replaceMirror(*around_, diameter);
}

void SessionModel::spray(double dt) {
    spray_.advance({.toolInTooth = newest_.proxy,
                    .normal = newest_.normal,
                    .speedRpm = newest_.speedRpm,
                    .water = water_ && newest_.cutting ? newest_.pedal : 0,
                    .suction = suction_,
                    .ground = simulator_->loss().ground()},
                   dt);
}

std::shared_ptr<const Surface> SessionModel::felt() const {
    return surrounded(simulator_->surface(), tooth_->piece->surroundings());
}

OrbitCamera::Direction SessionModel::defaultView() const {
    const OrbitCamera::Direction view{kEyeAzimuth, kEyeElevation};
    return mesialX() < 0 ? mirroredInX(view) : view;
}

SceneContents SessionModel::contents(bool withTurbine, bool withMirror) const {
    SceneContents contents;
    contents.materials = settings_.materials;
    if (simulator_ == nullptr) return contents;
    contents.tooth = simulator_->surface();
    contents.around = tooth_->around;
    contents.tool = ShownTool{.bur = bur_->shown,
                              .turbine = withTurbine && around_ ? around_->turbine : nullptr,
                              .material = bur_->material,
                              .toolInTooth = newest_.proxy,
                              .spin = spin_,
                              .speedRpm = newest_.speedRpm,
                              .edge = bur_->instrument.edge,
                              .blurred = bur_->blurred};
    contents.flying = particlesOf(spray_.particles(), settings_.materials);
    if (around_) addSurroundings(contents, withMirror);
    return contents;
}

void SessionModel::addSurroundings(SceneContents& contents, bool withMirror) const {
    if (suction_) contents.suction = ShownSuction{around_->suction, parkedSuction(tooth_->box(), tooth_->mesialX)};
    if (withMirror) {
        const auto [azimuth, elevation] = defaultView();
        const Vec3 toEye(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation));
        Pose mirror = parkedMirror(tooth_->box(), around_->disc, toEye, handleX());
        const Pose& moved = simulator_->mirrorMotion();
        mirror = {mirror.position + moved.position, (moved.rotation * mirror.rotation).normalized()};
        contents.mirror = ShownMirror{.mesh = around_->mirror,
                                      .disc = around_->disc,
                                      .mirrorInTooth = mirror,
                                      .fog = mirror_.fogged ? kBreath : 0,
                                      .drops = mirror_.wet ? kWetness : 0};
    }
}

}  // namespace tactooth
