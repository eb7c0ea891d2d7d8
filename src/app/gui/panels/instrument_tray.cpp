// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/instrument_tray.h"

#include <QActionGroup>
#include <algorithm>
#include <array>
#include <utility>

#include "app/gui/icons/instrument_picture.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/text/messages.h"
#include "app/gui/text/translation.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr int kPicture = 48;  // pixels: of each side

}  // namespace

InstrumentTray::InstrumentTray(QWidget* parent) : QToolBar(tr("Instruments"), parent), group_(new QActionGroup(this)) {
    setObjectName("instrumentTray");
    setIconSize({kPicture, kPicture});
    setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    const std::array drives = {std::pair(KeyId::TakeTurbine, tr("Turbine")),
                               std::pair(KeyId::TakeContraAngle, tr("Contra-angle")),
                               std::pair(KeyId::TakeLowSpeed, tr("Low speed"))};
    TACTOOTH_ASSERT(spindlePresets().size() == drives.size());
    for (std::size_t i = 0; i < drives.size(); ++i) {
        const SpindlePreset& drive = spindlePresets()[i];
        auto* action = new QAction(drives[i].second, this);
        const QString tip = translated(drive.name) + " (%1)";
        bindKey(*action, drives[i].first, tip);
        add({action, &drive, nullptr, tip}, "handpiece");
    }
    addSeparator();
    const std::array held = {
        std::pair(HandInstrument::Explorer, tr("Explorer (%1): touches; its tip sticks in soft decay")),
        std::pair(HandInstrument::Probe, tr("Periodontal probe (%1): reads how deep its tip stands")),
        std::pair(HandInstrument::Excavator, tr("Spoon excavator (%1): takes soft decay by hand"))};
    const std::array names = {tr("Explorer"), tr("Probe"), tr("Excavator")};
    const std::array keys = {KeyId::TakeExplorer, KeyId::TakeProbe, KeyId::TakeExcavator};
    for (std::size_t i = 0; i < held.size(); ++i) {
        auto* action = new QAction(names[i], this);
        bindKey(*action, keys[i], held[i].second);
        add({action, nullptr, &specOf(held[i].first), held[i].second}, "touch");
    }
    places_.front().action->setChecked(true);
    connect(group_, &QActionGroup::triggered, this, &InstrumentTray::choose);
    connect(&drawing_, &QTimer::timeout, this, &InstrumentTray::drawNext);
    drawing_.start(0);
}

/// `icon`: until its picture is drawn.
void InstrumentTray::add(const Place& place, const char* icon) {
    place.action->setCheckable(true);
    place.action->setObjectName(place.hand != nullptr ? QString::fromStdString("take-" + std::string(place.hand->name))
                                                      : "take-" + QString::fromStdString(place.drive->name));
    setLineIcon(*place.action, icon);
    group_->addAction(place.action);
    addAction(place.action);
    widgetForAction(place.action)->setFocusPolicy(Qt::TabFocus);  // so that Tab and the gamepad reach it
    places_.push_back(place);
}

void InstrumentTray::choose(const QAction* action) {
    const auto place = std::ranges::find(places_, action, &Place::action);
    TACTOOTH_ASSERT(place != places_.end());
    if (place->hand != nullptr) return emit handInstrumentChosen(place->hand->kind);
    emit handpieceChosen(*place->drive);
}

void InstrumentTray::show(std::optional<HandInstrument> hand, const QString& drive) {
    for (const Place& place : places_) {
        const bool isIt = hand ? place.hand != nullptr && place.hand->kind == *hand
                               : place.drive != nullptr && QString::fromStdString(place.drive->name) == drive;
        if (isIt) place.action->setChecked(true);
    }
}

void InstrumentTray::setAllowed(const Rule& rule) {
    for (const Place& place : places_) {
        const TrayInstrument instrument =
            place.hand != nullptr ? TrayInstrument(place.hand->kind) : TrayInstrument(handpieceOf(*place.drive));
        const bool isAllowed = !rule || rule(instrument);
        place.action->setEnabled(isAllowed);  // its key, too
        setTip(*place.action, isAllowed ? place.tip : place.tip + '\n' + translated(msg::kInstrumentNotAllowed));
    }
}

void InstrumentTray::setHandpieces(const HandpieceMeshes& handpieces) {
    handpieces_ = handpieces;
    drawing_.start(0);
}

bool InstrumentTray::isDrawing() const {
    return !std::ranges::all_of(places_, [](const Place& place) { return place.isDrawn; });
}

QImage InstrumentTray::drawn(const Place& place, QSize size) const {
    if (place.hand != nullptr) return drawHandInstrument(place.hand->kind, size);
    return drawHandpiece(*place.drive, *handpieces_->of(*place.drive), size);
}

void InstrumentTray::drawNext() {
    const auto next = std::ranges::find_if(
        places_, [this](const Place& place) { return !place.isDrawn && (place.hand != nullptr || handpieces_); });
    if (next == places_.end()) return drawing_.stop();
    const double ratio = devicePixelRatioF();
    QPixmap picture = QPixmap::fromImage(drawn(*next, (ratio * QSizeF(iconSize())).toSize()));
    picture.setDevicePixelRatio(ratio);
    next->action->setIcon(picture);
    next->isDrawn = true;
}

}  // namespace tactooth
