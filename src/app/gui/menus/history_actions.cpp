// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/history_actions.h"

#include <utility>

#include "app/gui/menus/instrument_menus.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/force_panel.h"
#include "app/gui/panels/history_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/text/translation.h"
#include "session/model/messages.h"

namespace tactooth {
namespace {

/// How the mouse presses belongs to the hand: the wheel turns it while the bur cuts.
ForceSettings withMouseOf(ForceSettings force, const ForceSettings& mouse) {
    force.press = mouse.press;
    force.mouse = mouse.mouse;
    force.depth = mouse.depth;
    force.flatFloor = mouse.flatFloor;
    return force;
}

}  // namespace

HistoryActions::HistoryActions(SessionModel& model, const ExaminationMode& mode, const WindowPanels& panels,
                               InstrumentMenus& instruments)
    : model_(model), mode_(mode), panels_(panels), instruments_(instruments) {
    addAspects();
    connect(panels_.drill->undoAction(), &QAction::triggered, this, [this] { model_.undo(); });
    connect(panels_.drill->redoAction(), &QAction::triggered, this, [this] { model_.redo(); });
    connect(panels_.history, &HistoryPanel::chosen, this, [this](std::size_t position) { model_.goTo(position); });
}

std::optional<LongWork> HistoryActions::undoing() {
    const std::optional<double> share = model_.history().share();
    if (!share) return std::nullopt;
    if (model_.history().isGivingUp()) return LongWork{.title = tr("Going back"), .share = share};
    return LongWork{.title = tr("Undo and redo"),
                    .share = share,
                    .cancel = [this] { model_.giveUpHistory(); },
                    .cancelTip = tr("Brings back the tooth as it was before")};
}

void HistoryActions::addAspects() {
    aspects_ = {
        {tr("Drive"), [](const Setup& a, const Setup& b) { return a.settings.spindle == b.settings.spindle; },
         [this](const Setup& to) { panels_.drill->choose({}, QString::fromStdString(to.settings.spindle)); }},
        {tr("Water spray"), [](const Setup& a, const Setup& b) { return a.settings.water == b.settings.water; },
         [this](const Setup& to) {
             WindowSettings now = setup().settings;
             now.water = to.settings.water;
             instruments_.restore(now);
         }},
        {tr("Suction"), [](const Setup& a, const Setup& b) { return a.settings.suction == b.settings.suction; },
         [this](const Setup& to) {
             WindowSettings now = setup().settings;
             now.suction = to.settings.suction;
             instruments_.restore(now);
         }},
        {tr("Mirror"), [](const Setup& a, const Setup& b) { return a.settings.mirror == b.settings.mirror; },
         [this](const Setup& to) {
             WindowSettings now = setup().settings;
             now.mirror = to.settings.mirror;
             instruments_.restore(now);
         }},
        {tr("Force"),
         [](const Setup& a, const Setup& b) {
             return withMouseOf(a.settings.force, b.settings.force) == b.settings.force;
         },
         [this](const Setup& to) { panels_.force->set(withMouseOf(to.settings.force, panels_.force->settings())); }},
        {tr("Look inside"), [](const Setup& a, const Setup& b) { return a.enamel == b.enamel && a.dentin == b.dentin; },
         [this](const Setup& to) {
             InspectionPanel::Choice choice = panels_.inspection->choice();
             choice.enamel = to.enamel;
             choice.dentin = to.dentin;
             panels_.inspection->choose(choice);
         }}};
}

HistoryActions::Setup HistoryActions::setup() const {
    Setup now;
    instruments_.store(now.settings);
    now.settings.spindle = panels_.drill->spindleName().toStdString();
    now.settings.force = panels_.force->settings();
    const InspectionPanel::Choice choice = panels_.inspection->choice();
    now.enamel = choice.enamel;
    now.dentin = choice.dentin;
    return now;
}

void HistoryActions::note(const Aspect& aspect, int kind, const Setup& before, const Setup& after) {
    const auto back = [this, apply = aspect.apply](const Setup& to) {
        apply(to);
        seen_ = setup();
    };
    model_.noteChange({Message::verbatim(aspect.name.toStdString()), 0, [back, before] { back(before); },
                       [back, after] { back(after); }, kind});
}

void HistoryActions::update() {
    const Setup now = setup();
    // Without a tooth, or with another one than before, there is nothing to go back to.
    if (model_.runner() != nullptr && seenTooth_ == model_.tooth()->piece.get()) {
        for (std::size_t i = 0; i < aspects_.size(); ++i) {
            if (!aspects_[i].isSame(seen_, now)) note(aspects_[i], static_cast<int>(i) + 1, seen_, now);
        }
    }
    seen_ = now;
    const WorkHistory& history = model_.history();
    panels_.history->show(history);
    panels_.drill->undoAction()->setEnabled(mode_.allowsTakingBack() && history.position() > 0);
    panels_.drill->redoAction()->setEnabled(mode_.allowsTakingBack() && history.position() < history.steps().size());
}

void HistoryActions::install(const SessionBur& bur) {
    expectedBur_ = bur.instrument.shape.get();
    model_.install(bur);
}

void HistoryActions::takeRunner() {
    const SessionBur now = *model_.bur();
    const CutModel* const tooth = model_.tooth()->piece.get();
    const bool isOther = seenBur_ && seenBur_->instrument.shape != now.instrument.shape;
    const bool isOurs = std::exchange(expectedBur_, nullptr) == now.instrument.shape.get();
    if (isOther && !isOurs && tooth == seenTooth_) {
        const MessageText& step = now.isHandInstrument() ? msg::kStepInstrument : msg::kStepBur;
        model_.noteChange({Message(step, translated(now.name).toStdString()), 0,
                           [this, before = *seenBur_] { install(before); }, [this, now] { install(now); }, 0});
    }
    if (tooth != seenTooth_) seen_ = setup();
    seenTooth_ = tooth;
    seenBur_ = now;
}

}  // namespace tactooth
