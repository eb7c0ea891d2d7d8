// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the window does with the device in the hand and the pedal under the foot.
#include <algorithm>
#include <string_view>
#include <utility>

#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/panels/hand_panel.h"
#include "app/gui/window/main_window.h"
#include "app/gui/panels/status_line.h"
#include "devices/open_device.h"
#include "session/scripts/replay_hand.h"

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

void MainWindow::connectHand() {
    connect(handPanel_, &HandPanel::deviceChosen, this, &MainWindow::steerBy);
    connect(handPanel_, &HandPanel::secondDeviceChosen, this, &MainWindow::holdMirrorBy);
    connect(handPanel_, &HandPanel::changed, this, &MainWindow::takeHandSettings);
    connect(handPanel_, &HandPanel::teachingChanged, this, [this](bool teaching) {
        if (teaching == pedal_.isTeaching()) return;
        if (const auto done = pedal_.teach(teaching); !done) complain(done.error());
        handPanel_->setTeaching(pedal_.isTeaching());
        if (pedal_.isTeaching()) {
            status_->setHint(tr("Press the pedal fully, then let it go"));
        } else {
            showUsualHint();
        }
    });
    takeHandSettings();
}

void MainWindow::takeHandSettings() {
    const HandSettings settings = handPanel_->settings();
    bench_.letFit(settings.fineness == kFit);
    if (settings.fineness != kFit) bench_.controls.fineness = settings.fineness;
    bench_.controls.buttons = handPanel_->buttons();
    bench_.controls.clutch = handPanel_->clutch();
    if (settings.leftHanded != bench_.isLeftHanded() || settings.rate != bench_.rate()) {
        bench_.setLeftHanded(settings.leftHanded);
        bench_.setRate(settings.rate);
        // They may change over too.
        if (bench_.secondDevice() != nullptr) holdMirrorBy(QString::fromStdString(settings.secondDevice));
        if (bench_.device() != nullptr) steerBy(QString::fromStdString(settings.device));
    }
    pedalKey_ = pedalKeyOf(settings);
}

void MainWindow::applyHand(const HandSettings& settings) {
    handPanel_->set(settings);
    const Expected<PedalChoice> pedal = parsePedal(settings.pedal);
    if (!pedal) {
        complain(pedal.error());
        handPanel_->showPedal({}, 0, 1);
    } else {
        PedalChoice choice = *pedal;
        choice.up = settings.pedalUp;
        choice.down = settings.pedalDown;
        const auto done = pedal_.choose(choice);
        if (!done) complain(done.error());
    }
    device_ = settings.device;
    second_ = settings.secondDevice;
    steerBy(QString::fromStdString(settings.device));
    holdMirrorBy(QString::fromStdString(settings.secondDevice));
}

HandSettings MainWindow::handSettings() const {
    HandSettings settings = handPanel_->settings();
    settings.device = device_;
    settings.secondDevice = second_;
    return settings;
}

void MainWindow::steerBy(const QString& name) {
    handPanel_->showDevice(name);
    comingDevice_.forget();
    if (bench_.device() != nullptr) bench_.useMouse();
    if (name == kMouse) {
        device_ = kMouse;
        return;
    }
    status_->setHint(tr("Opening the device…"));
    comingDevice_.start([wanted = name.toStdString(), left = bench_.isLeftHanded(), rate = bench_.rate()] {
        return openHand(wanted, left, rate);
    });
}

void MainWindow::holdMirrorBy(const QString& name) {
    handPanel_->showSecondDevice(name);
    comingSecond_.forget();
    bench_.putSecond(nullptr);
    if (name.isEmpty() || name == kNoDevice) {
        second_ = kNoDevice;
        return;
    }
    comingSecond_.start([wanted = name.toStdString(), left = bench_.isLeftHanded(), rate = bench_.rate()] {
        return openHand(wanted, left, rate);
    });
}

void MainWindow::takeDevices() {
    if (auto device = comingDevice_.poll()) {
        if (*device) {
            bench_.put(std::move(**device));
            device_ = handPanel_->settings().device;
            if (isReplay(device_)) device_ = kMouse;  // a way is gone once, and not at each start
            showUsualHint();
        } else {
            handPanel_->showDevice(kMouse);
            complain(device->error());
        }
    }
    if (auto second = comingSecond_.poll()) {
        if (*second) {
            bench_.putSecond(std::move(**second));
            second_ = handPanel_->settings().secondDevice;
        } else {
            handPanel_->showSecondDevice(kNoDevice);
            complain(second->error());
        }
    }
}

/// The foot, the space key and the slider: whichever is furthest down.
void MainWindow::stepPedal() {
    const bool wasTeaching = pedal_.isTeaching();
    const double foot = pedal_.step();
    if (wasTeaching && !pedal_.isTeaching()) {
        const PedalChoice& taught = pedal_.choice();
        handPanel_->showPedal(pedalText(taught), taught.up, taught.down);
        handPanel_->setTeaching(false);
        status_->setHint(tr("The pedal is %1").arg(QString::fromStdString(pedalText(taught))));
    }
    bench_.controls.pedal = std::max(foot, drive_->pedal());
}

bool MainWindow::isSteeredByPad() const { return bench_.device() != nullptr && device_.starts_with(kGamepad); }

void MainWindow::stepPad(double dt) {
    const bool wasInPanels = pad_.isInPanels();
    pad_.listenTo(isSteeredByPad() ? std::optional(padName(device_)) : std::nullopt);
    if (pad_.step(dt)) stillSteps_ = 0;
    bench_.letDeviceRest(pad_.holdsHand());
    if (wasInPanels != pad_.isInPanels()) showUsualHint();
}

/// A button of the device chooses touch or cut too: the bar follows it, once the choice of the bar itself has arrived.
void MainWindow::followButtons() {
    const bool agrees = bench_.newest().cutting == drill_->isCutting();
    if (agrees || bench_.device() == nullptr || bench_.ticks().empty()) {
        disagreesSince_ = bench_.newest().time;
    } else if (bench_.newest().time > disagreesSince_ + kButtonTime) {
        drill_->showCutting(bench_.newest().cutting);
    }
}

void MainWindow::showHand() {
    const HapticDevice* device = bench_.device();
    Simulator* simulator = bench_.simulator();
    const ForceState force = simulator != nullptr ? simulator->forceState() : ForceState::Off;
    handPanel_->showState(device != nullptr ? QString::fromStdString(device->info().name) : QString(), force,
                          device != nullptr ? device->trouble() : nullptr);
    const HapticDevice* second = bench_.secondDevice();
    handPanel_->showSecondState(second != nullptr ? QString::fromStdString(second->info().name) : QString(),
                                second != nullptr ? second->trouble() : nullptr);
    handPanel_->showFit(bench_.fit());
    hintAtHand();
}

MainWindow::HandHint MainWindow::handHint() {
    const HapticDevice* device = bench_.device();
    Simulator* simulator = bench_.simulator();
    if (simulator == nullptr || tour_->isRunning()) return HandHint::None;
    const Tick& tick = bench_.newest();
    if (device != nullptr) {
        if (device->trouble() != nullptr) return HandHint::None;  // that comes first: see takeNews
        if (simulator->forceState() == ForceState::WaitsForFree && tick.contacts > 0) return HandHint::ForceWaits;
        if (simulator->isHandAtEnd()) return HandHint::AtEnd;
    }
    const bool presses = device != nullptr || bench_.hand().isPressing();  // a bur may rest in its cavity
    if (tick.contacts == 0 || !presses) return HandHint::None;
    if (tick.cutting) return tick.pedal == 0 ? HandHint::BurStands : HandHint::None;
    return tick.pedal > 0 ? HandHint::OnlyTouches : HandHint::None;
}

QString MainWindow::hintText(HandHint hint) const {
    switch (hint) {
        case HandHint::ForceWaits:
            return forceStateText(ForceState::WaitsForFree);
        case HandHint::AtEnd:
            return tr("The hand is at the end of the device's room: hold the bur (X), bring the hand back and let go");
        case HandHint::BurStands:
            return tr("The bur stands still: hold the pedal (%1), or tick Keep down")
                .arg(QKeySequence(pedalKey_).toString(QKeySequence::NativeText));
        case HandHint::OnlyTouches:
            return tr("The bur only touches: choose Cut (C) to remove something");
        case HandHint::None:
            break;
    }
    return {};
}

void MainWindow::hintAtHand() {
    const HandHint hint = handHint();
    if (hint == std::exchange(handHint_, hint)) return;
    if (hint == HandHint::None) return showUsualHint();
    status_->setHint(hintText(hint));
}

}  // namespace tactooth
