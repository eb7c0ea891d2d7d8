// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/instrument_controller.h"

#include <algorithm>
#include <utility>

#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/instrument_tray.h"
#include "assessment/allowed_instruments.h"
#include "instruments/bur_catalogue.h"

namespace tactooth {

InstrumentController::InstrumentController(SessionModel& model, const WindowPanels& panels)
    : model_(model), panels_(panels) {
    connect(panels_.tray, &InstrumentTray::handpieceChosen, this, &InstrumentController::takeHandpiece);
    connect(panels_.tray, &InstrumentTray::handInstrumentChosen, this, &InstrumentController::takeHandInstrument);
    connect(panels_.drill, &DrillBar::spindleChosen, this,
            [this] { panels_.tray->show(shown_, panels_.drill->spindleName()); });
}

/// The handpiece comes back with the bur that it had.
void InstrumentController::takeHandpiece(const SpindlePreset& drive) {
    const QString name = QString::fromStdString(drive.name);
    if (name != panels_.drill->spindleName()) panels_.drill->choose({}, name);
    if (!model_.bur() || !model_.bur()->isHandInstrument()) return;
    if (bur_) {
        model_.install(*bur_);
    } else {
        panels_.drill->takeBur(panels_.drill->currentBur());  // the window began with a hand instrument
    }
}

void InstrumentController::takeHandInstrument(HandInstrument kind) {
    if (model_.bur() && model_.bur()->instrument.hand == kind) return;
    model_.install(makeHandInstrument(kind));
}

void InstrumentController::follow(std::shared_ptr<const Exercise> exercise) {
    exercise_ = std::move(exercise);
    if (exercise_ == nullptr) {
        panels_.drill->setAllowed({}, {});
        panels_.tray->setAllowed({});
        return;
    }
    panels_.drill->setAllowed(
        [exercise = exercise_](const QString& number, const QString& file) {
            return file.isEmpty() ? allowsBur(*exercise, number.toStdString())
                                  : allowsBurFile(*exercise, file.toStdString());
        },
        [exercise = exercise_](const SpindlePreset& drive) { return allows(*exercise, handpieceOf(drive)); });
    panels_.tray->setAllowed(
        [exercise = exercise_](const TrayInstrument& instrument) { return allows(*exercise, instrument); });
    keepToExercise();
}

/// An instrument that is not allowed may come from a saved tooth, the history, or the work before the exercise.
void InstrumentController::keepToExercise() {
    if (exercise_ == nullptr || !model_.bur()) return;
    const auto drive = std::ranges::find_if(
        spindlePresets(), [this](const SpindlePreset& each) { return allows(*exercise_, handpieceOf(each)); });
    if (!allows(*exercise_, handpieceOf(model_.haptics().spindle)))
        panels_.drill->choose({}, QString::fromStdString(drive->name));
    const SessionBur& now = *model_.bur();
    if (now.isHandInstrument()) {
        if (!allows(*exercise_, *now.instrument.hand)) takeHandpiece(model_.haptics().spindle);
        return;
    }
    const auto known = std::ranges::find(burCatalogue(), now.name, &BurSpec::name);
    const std::string number = now.file.empty() && known != burCatalogue().end() ? known->number : std::string();
    const bool isAllowed = now.file.empty() ? allowsBur(*exercise_, number) : allowsBurFile(*exercise_, now.file);
    const auto* own = std::get_if<std::string>(&exercise_->bur);
    if (!isAllowed && own != nullptr) panels_.drill->choose(QString::fromStdString(findBur(*own)->number), {});
}

void InstrumentController::takeRunner() {
    const SessionBur& now = *model_.bur();
    if (!now.isHandInstrument()) bur_ = now;
    panels_.tray->show(now.instrument.hand, panels_.drill->spindleName());
    if (std::exchange(shown_, now.instrument.hand) != now.instrument.hand) emit changed();
    keepToExercise();
}

void InstrumentController::poll() {
    const std::optional<InstrumentMeshes>& meshes = model_.instruments().meshes();
    if (meshes && !std::exchange(hasHandpieces_, true)) panels_.tray->setHandpieces(meshes->handpieces);
}

}  // namespace tactooth
