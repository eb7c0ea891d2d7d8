// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the window does with the device in the hand and the pedal under the foot.
#include <algorithm>
#include <string_view>
#include <utility>

#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/panels/device_panel.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/window/main_window.h"
#include "devices/open_device.h"
#include "session/scripts/replay_device.h"

namespace tactooth {
namespace {

constexpr const char* kMouse = "mouse";
constexpr const char* kNoDevice = "none";
constexpr std::string_view kGamepad = "gamepad";
constexpr double kButtonTime = 0.3;  // s after which the bar shows what a button of the device has chosen

/// What stands behind the colon of `device`: a part of its name.
std::string padName(const std::string& device) {
    return device.size() > kGamepad.size() ? device.substr(kGamepad.size() + 1) : std::string();
}

}  // namespace

void MainWindow::connectDevice() {
    connect(devicePanel_, &DevicePanel::deviceChosen, this, &MainWindow::openFirstDevice);
    connect(devicePanel_, &DevicePanel::secondDeviceChosen, this, &MainWindow::openSecondDevice);
    connect(devicePanel_, &DevicePanel::changed, this, &MainWindow::readDeviceSettings);
    connect(devicePanel_, &DevicePanel::calibratingChanged, this, [this](bool calibrating) {
        if (calibrating == pedal_.isCalibrating()) return;
        if (const auto done = pedal_.setCalibrating(calibrating); !done) showError(done.error());
        devicePanel_->setCalibrating(pedal_.isCalibrating());
        if (pedal_.isCalibrating()) {
            status_->setHint(tr("Press the pedal fully, then let it go"));
        } else {
            showUsualHint();
        }
    });
    readDeviceSettings();
}

void MainWindow::readDeviceSettings() {
    const DeviceSettings settings = devicePanel_->settings();
    model_.setAutoScaling(settings.motionScaling == kAutoScaling);
    if (settings.motionScaling != kAutoScaling) model_.controls.motionScaling = settings.motionScaling;
    model_.controls.buttons = devicePanel_->buttons();
    model_.controls.clutch = devicePanel_->clutch();
    if (settings.leftHanded != model_.isLeftHanded() || settings.rate != model_.rate()) {
        model_.setLeftHanded(settings.leftHanded);
        model_.setRate(settings.rate);
        // They may change over too.
        if (model_.secondDevice() != nullptr) openSecondDevice(QString::fromStdString(settings.secondDevice));
        if (model_.device() != nullptr) openFirstDevice(QString::fromStdString(settings.device));
    }
    pedalKey_ = pedalKeyOf(settings);
}

void MainWindow::applyDeviceSettings(const DeviceSettings& settings) {
    devicePanel_->set(settings);
    const Expected<PedalBinding> pedal = parsePedal(settings.pedal);
    if (!pedal) {
        showError(pedal.error());
        devicePanel_->showPedal({}, 0, 1);
    } else {
        PedalBinding choice = *pedal;
        choice.up = settings.pedalUp;
        choice.down = settings.pedalDown;
        const auto done = pedal_.choose(choice);
        if (!done) showError(done.error());
    }
    device_ = settings.device;
    second_ = settings.secondDevice;
    openFirstDevice(QString::fromStdString(settings.device));
    openSecondDevice(QString::fromStdString(settings.secondDevice));
}

DeviceSettings MainWindow::deviceSettings() const {
    DeviceSettings settings = devicePanel_->settings();
    settings.device = device_;
    settings.secondDevice = second_;
    return settings;
}

void MainWindow::openFirstDevice(const QString& name) {
    devicePanel_->showDevice(name);
    pendingDevice_.cancel();
    if (model_.device() != nullptr) model_.useMouse();
    if (name == kMouse) {
        device_ = kMouse;
        return;
    }
    status_->setHint(tr("Opening the device…"));
    pendingDevice_.start([wanted = name.toStdString(), left = model_.isLeftHanded(), rate = model_.rate()] {
        return openDeviceOrReplay(wanted, left, rate);
    });
}

void MainWindow::openSecondDevice(const QString& name) {
    devicePanel_->showSecondDevice(name);
    pendingSecondDevice_.cancel();
    model_.installSecond(nullptr);
    if (name.isEmpty() || name == kNoDevice) {
        second_ = kNoDevice;
        return;
    }
    pendingSecondDevice_.start([wanted = name.toStdString(), left = model_.isLeftHanded(), rate = model_.rate()] {
        return openDeviceOrReplay(wanted, left, rate);
    });
}

void MainWindow::collectDevices() {
    if (auto device = pendingDevice_.poll()) {
        if (*device) {
            model_.install(std::move(**device));
            device_ = devicePanel_->settings().device;
            if (isReplay(device_)) device_ = kMouse;  // a way is gone once, and not at each start
            showUsualHint();
        } else {
            devicePanel_->showDevice(kMouse);
            showError(device->error());
        }
    }
    if (auto second = pendingSecondDevice_.poll()) {
        if (*second) {
            model_.installSecond(std::move(**second));
            second_ = devicePanel_->settings().secondDevice;
        } else {
            devicePanel_->showSecondDevice(kNoDevice);
            showError(second->error());
        }
    }
}

/// The foot, the space key and the slider: whichever is furthest down.
void MainWindow::stepPedal() {
    const bool wasCalibrating = pedal_.isCalibrating();
    const double foot = pedal_.step();
    if (wasCalibrating && !pedal_.isCalibrating()) {
        const PedalBinding& taught = pedal_.choice();
        devicePanel_->showPedal(pedalText(taught), taught.up, taught.down);
        devicePanel_->setCalibrating(false);
        status_->setHint(tr("The pedal is %1").arg(QString::fromStdString(pedalText(taught))));
    }
    model_.controls.pedal = std::max(foot, drive_->pedal());
}

bool MainWindow::usesGamepad() const { return model_.device() != nullptr && device_.starts_with(kGamepad); }

void MainWindow::stepGamepad(double dt) {
    const bool wasInPanels = gamepad_.isInPanels();
    gamepad_.setGamepad(usesGamepad() ? std::optional(padName(device_)) : std::nullopt);
    if (gamepad_.step(dt)) idleSteps_ = 0;
    model_.setDeviceResting(gamepad_.capturesInput());
    if (wasInPanels != gamepad_.isInPanels()) showUsualHint();
}

/// A button of the device chooses touch or cut too: the bar follows it, once the choice of the bar itself has arrived.
void MainWindow::followButtons() {
    const bool agrees = model_.newest().cutting == drill_->isCutting();
    if (agrees || model_.device() == nullptr || model_.ticks().empty()) {
        disagreesSince_ = model_.newest().time;
    } else if (model_.newest().time > disagreesSince_ + kButtonTime) {
        drill_->showCutting(model_.newest().cutting);
    }
}

void MainWindow::showDeviceState() {
    const HapticDevice* device = model_.device();
    Simulator* simulator = model_.simulator();
    const ForceState force = simulator != nullptr ? simulator->forceState() : ForceState::Off;
    devicePanel_->showState(device != nullptr ? QString::fromStdString(device->info().name) : QString(), force,
                            device != nullptr ? device->faultMessage() : nullptr);
    const HapticDevice* second = model_.secondDevice();
    devicePanel_->showSecondState(second != nullptr ? QString::fromStdString(second->info().name) : QString(),
                                  second != nullptr ? second->faultMessage() : nullptr);
    devicePanel_->showFit(model_.fit());
    showDeviceHint();
}

MainWindow::DeviceHint MainWindow::deviceHint() {
    const HapticDevice* device = model_.device();
    Simulator* simulator = model_.simulator();
    if (simulator == nullptr || tour_->isRunning()) return DeviceHint::None;
    const Tick& tick = model_.newest();
    if (device != nullptr) {
        if (device->faultMessage() != nullptr) return DeviceHint::None;  // that comes first: see applyStepResult
        if (simulator->forceState() == ForceState::AwaitsFreeSpace && tick.contacts > 0) return DeviceHint::ForceWaits;
        if (simulator->isDeviceAtWorkspaceLimit()) return DeviceHint::WorkspaceEnd;
    }
    const bool presses = device != nullptr || model_.manipulator().isPressing();  // a bur may rest in its cavity
    if (tick.contacts == 0 || !presses) return DeviceHint::None;
    if (tick.cutting) return tick.pedal == 0 ? DeviceHint::BurStopped : DeviceHint::None;
    return tick.pedal > 0 ? DeviceHint::OnlyTouches : DeviceHint::None;
}

QString MainWindow::deviceHintText(DeviceHint hint) const {
    switch (hint) {
        case DeviceHint::ForceWaits:
            return forceStateText(ForceState::AwaitsFreeSpace);
        case DeviceHint::WorkspaceEnd:
            return tr("The hand is at the end of the device's room: hold the bur (X), bring the hand back and let go");
        case DeviceHint::BurStopped:
            return tr("The bur stands still: hold the pedal (%1), or tick Keep down")
                .arg(QKeySequence(pedalKey_).toString(QKeySequence::NativeText));
        case DeviceHint::OnlyTouches:
            return tr("The bur only touches: choose Cut (C) to remove something");
        case DeviceHint::None:
            break;
    }
    return {};
}

void MainWindow::showDeviceHint() {
    const DeviceHint hint = deviceHint();
    if (hint == std::exchange(deviceHint_, hint)) return;
    if (hint == DeviceHint::None) return showUsualHint();
    status_->setHint(deviceHintText(hint));
}

}  // namespace tactooth
