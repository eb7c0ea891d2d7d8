// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/drill_bar.h"

#include <QActionGroup>
#include <QLabel>
#include <QStandardItemModel>

#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/panels/bur_box.h"
#include "app/gui/text/messages.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

constexpr int kFileRole = Qt::UserRole + 1;  // besides the number in the catalogue
constexpr int kNameRole = Qt::UserRole + 2;  // not translated

/// Keys and the wheel skip what is not allowed.
void allow(QComboBox& box, int place, bool isAllowed, const MessageText& why) {
    QStandardItem& item = *qobject_cast<QStandardItemModel*>(box.model())->item(place);
    item.setEnabled(isAllowed);
    item.setToolTip(isAllowed ? QString() : translated(why));
}

bool isAllowed(const QComboBox& box, int place) {
    return qobject_cast<const QStandardItemModel*>(box.model())->item(place)->isEnabled();
}

}  // namespace

DrillBar::DrillBar(QWidget* parent) : QToolBar(tr("Drill"), parent), burs_(new BurBox), spindles_(new QComboBox) {
    setObjectName("drillBar");
    for (const BurSpec& spec : burCatalogue()) {
        burs_->addItem(translated(spec.title), QString::fromStdString(spec.number));
        burs_->setItemData(burs_->count() - 1, QString::fromStdString(spec.name), kNameRole);
    }
    for (const SpindlePreset& spindle : spindlePresets()) {
        spindles_->addItem(translated(spindle.name), QString::fromStdString(spindle.name));
    }
    burs_->setObjectName("burs");
    burs_->setToolTip(tr("The bur in the handpiece"));
    burs_->setCurrentIndex(burs_->findData("4"));
    spindles_->setToolTip(tr("What turns the bur"));
    addWidget(new QLabel(tr(" Bur ")));
    addWidget(burs_);
    addWidget(new QLabel(tr("  Drive ")));
    addWidget(spindles_);
    addSeparator();
    addModes();
    connect(burs_, &BurBox::gridWanted, this, &DrillBar::gridWanted);
    connect(burs_, &QComboBox::activated, this, [this](int index) {
        const QString file = burs_->itemData(index, kFileRole).toString();
        if (!file.isEmpty()) emit burFileChosen(file);
        if (const auto spec = findBur(burs_->itemData(index).toString().toStdString())) emit burChosen(*spec);
    });
    // A narrow window cuts their texts short.
    for (QComboBox* box : {static_cast<QComboBox*>(burs_), spindles_}) {
        connect(box, &QComboBox::currentTextChanged, box,
                [box, tip = box->toolTip()](const QString& text) { box->setToolTip(tip + ": " + text); });
        emit box->currentTextChanged(box->currentText());
    }
    connect(spindles_, &QComboBox::activated, this,
            [this](int index) { emit spindleChosen(spindlePresets()[static_cast<std::size_t>(index)]); });
}

void DrillBar::addModes() {
    auto* modes = new QActionGroup(this);
    touch_ = modes->addAction(tr("Touch"));
    bindKey(*touch_, KeyId::Touch, tr("Touch (%1): the bur stands still and feels the tooth"));
    cut_ = modes->addAction(tr("Cut"));
    bindKey(*cut_, KeyId::Cut, tr("Cut (%1): with the pedal down the bur turns and cuts"));
    for (QAction* mode : {touch_, cut_}) mode->setCheckable(true);
    setLineIcon(*touch_, "touch");
    setLineIcon(*cut_, "cut");
    touch_->setChecked(true);
    addActions(modes->actions());
    connect(cut_, &QAction::toggled, this, [this](bool cutting) {
        if (!showing_) emit cuttingChanged(cutting);
    });
    addSeparator();
    undo_ = addAction(lineIcon("undo"), tr("Undo"));
    undo_->setObjectName("undo");
    bindKey(*undo_, KeyId::Undo, tr("Takes back the last cut or change (%1)"));
    redo_ = addAction(lineIcon("redo"), tr("Redo"));
    redo_->setObjectName("redo");
    bindKey(*redo_, KeyId::Redo, tr("Does again what was taken back (%1)"));
    reset_ = addAction(lineIcon("reset"), tr("Reset tooth"));
    bindKey(*reset_, KeyId::ResetTooth, tr("Puts back all that was cut (%1); Undo takes that back"));
}

void DrillBar::showCutting(bool cutting) {
    showing_ = true;
    (cutting ? cut_ : touch_)->setChecked(true);
    showing_ = false;
}

std::vector<BurItem> DrillBar::burs() const {
    std::vector<BurItem> items;
    for (int i = 0; i < burs_->count(); ++i) {
        const bool isFile = !burs_->itemData(i, kFileRole).toString().isEmpty();
        const std::string number = isFile ? std::string() : burs_->itemData(i).toString().toStdString();
        items.push_back({i, burs_->itemText(i), number.empty() ? std::nullopt : findBur(number), isAllowed(*burs_, i)});
    }
    return items;
}

int DrillBar::currentBur() const { return burs_->currentIndex(); }

QString DrillBar::burNumber() const { return burs_->currentData().toString(); }

void DrillBar::takeBur(int place) {
    if (!isAllowed(*burs_, place)) return;
    burs_->setCurrentIndex(place);
    emit burs_->activated(place);
}

void DrillBar::choose(const QString& burNumber, const QString& spindleName) {
    const int bur = burNumber.isEmpty() ? -1 : burs_->findData(burNumber);
    if (bur >= 0) takeBur(bur);
    const int spindle = spindles_->findData(spindleName);
    if (spindle >= 0 && isAllowed(*spindles_, spindle))
        spindles_->setCurrentIndex(spindle), emit spindles_->activated(spindle);
}

void DrillBar::show(const QString& name, const QString& file) {
    int place = file.isEmpty() ? burs_->findData(name, kNameRole) : burs_->findData(file, kFileRole);
    if (place < 0) {
        place = burs_->count();
        burs_->addItem(name);
        burs_->setItemData(place, file, kFileRole);
        burs_->setItemData(place, name, kNameRole);
        showAllowed(place);
    }
    burs_->setCurrentIndex(place);
}

void DrillBar::setAllowed(BurRule bur, const DriveRule& drive) {
    allowsBur_ = std::move(bur);
    for (int i = 0; i < burs_->count(); ++i) showAllowed(i);
    for (int i = 0; i < spindles_->count(); ++i) {
        const bool isOffered = !drive || drive(spindlePresets()[static_cast<std::size_t>(i)]);
        allow(*spindles_, i, isOffered, msg::kInstrumentNotAllowed);
    }
}

void DrillBar::showAllowed(int bur) {
    const QString file = burs_->itemData(bur, kFileRole).toString();
    const bool isOffered = !allowsBur_ || allowsBur_(burs_->itemData(bur).toString(), file);
    allow(*burs_, bur, isOffered, msg::kBurNotAllowed);
}

}  // namespace tactooth
