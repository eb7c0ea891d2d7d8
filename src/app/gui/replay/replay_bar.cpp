// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_bar.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QShortcut>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/panels/elided_label.h"
#include "app/gui/replay/clock_text.h"
#include "app/gui/replay/replay_cursor.h"

namespace tactooth {
ReplayBar::ReplayBar(QWidget* parent)
    : QWidget(parent), slider_(new ReplaySlider), time_(new QLabel), speeds_(new QComboBox), note_(new QLabel) {
    setObjectName("replayBar");
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(6, 2, 6, 4);
    auto* upper = new QHBoxLayout;
    upper->addWidget(slider_, 1);
    upper->addWidget(time_);
    rows->addLayout(upper);
    auto* lower = new QHBoxLayout;
    rows->addLayout(lower);

    play_ = addButton("replayPlay", tr("Pause"), tr("Plays or pauses the recording"), KeyId::ReplayPlay);
    connect(play_, &QToolButton::clicked, this, &ReplayBar::playToggled);
    const auto addIcon = [this](const char* name, const char* icon, const QString& tip, KeyId key) {
        QToolButton* const button = addButton(name, {}, tip, key);
        button->setIcon(lineIcon(icon));
        return button;
    };
    connect(addIcon("replayPrevious", "previous-event", tr("To the event or comment before"), KeyId::ReplayPrevious),
            &QToolButton::clicked, this, &ReplayBar::previousWanted);
    connect(addIcon("replayBack", "tick-back", tr("Back by one tick"), KeyId::ReplayBack), &QToolButton::clicked, this,
            [this] { emit stepped(-1); });
    connect(addIcon("replayOn", "tick-on", tr("On by one tick"), KeyId::ReplayOn), &QToolButton::clicked, this,
            [this] { emit stepped(1); });
    connect(addIcon("replayNext", "next-event", tr("To the next event or comment"), KeyId::ReplayNext),
            &QToolButton::clicked, this, &ReplayBar::nextWanted);
    addSpeeds();
    addComments();
    compare_ =
        addButton("replayCompare", tr("Compare…"), tr("Opens another recording to compare with, or closes it"), {});
    compare_->setCheckable(true);
    connect(compare_, &QToolButton::clicked, this, &ReplayBar::compareToggled);
    note_->setObjectName("replayNote");
    note_->setTextFormat(Qt::PlainText);
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    static_cast<QBoxLayout*>(layout()->itemAt(1)->layout())->addWidget(note_, 1);
    connect(addButton("replayLeave", tr("Leave replay"), tr("Back to the tooth as it was"), KeyId::ReplayLeave),
            &QToolButton::clicked, this, &ReplayBar::leaveWanted);

    otherRow_ = makeOtherRow();
    rows->addWidget(otherRow_);
    showOther({}, 0);
    time_->setObjectName("replayClock");
    connect(slider_, &ReplaySlider::timeChosen, this, &ReplayBar::timeChosen);
}

/// Its key works wherever the focus is, as long as the bar is visible.
QToolButton* ReplayBar::addButton(const char* name, const QString& text, const QString& tip, std::optional<KeyId> key) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    static_cast<QBoxLayout*>(layout()->itemAt(1)->layout())->addWidget(button);
    if (!key) return button;
    auto* shortcut = new QShortcut(this);
    bindKey(*shortcut, *key, *button, tip + " (%1)");
    connect(shortcut, &QShortcut::activated, button, &QToolButton::click);
    return button;
}

void ReplayBar::addSpeeds() {
    speeds_->setObjectName("replaySpeed");
    speeds_->setToolTip(tr("Speed of the replay"));
    for (const double speed : ReplayCursor::kSpeeds) speeds_->addItem(tr("%1 ×").arg(speed), speed);
    speeds_->setCurrentIndex(speeds_->findData(ReplayCursor::kOwnSpeed));
    connect(speeds_, &QComboBox::activated, this, [this] { emit speedChosen(speeds_->currentData().toDouble()); });
    static_cast<QBoxLayout*>(layout()->itemAt(1)->layout())->addWidget(speeds_);
}

void ReplayBar::addComments() {
    QToolButton* comment = addButton("replayComment", tr("Comment…"), tr("Pins a comment to this moment"), {});
    comment->setPopupMode(QToolButton::MenuButtonPopup);
    comments_ = new QMenu(comment);
    comment->setMenu(comments_);
    connect(comment, &QToolButton::clicked, this, &ReplayBar::commentWanted);
}

/// What belongs to the other recording.
QWidget* ReplayBar::makeOtherRow() {
    auto* widget = new QWidget;
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    otherName_ = new ElidedLabel;
    otherName_->setObjectName("replayOtherName");
    auto* label = new QLabel(tr("&begins later by"));
    constexpr double kMost = 3600, kStep = 0.1;  // s
    shift_ = new QDoubleSpinBox;
    shift_->setObjectName("replayShift");
    shift_->setRange(-kMost, kMost);
    shift_->setSingleStep(kStep);
    shift_->setDecimals(2);
    shift_->setSuffix(tr(" s"));
    shift_->setKeyboardTracking(false);  // a typed number counts when it is complete
    shift_->setToolTip(tr("How much later the other recording begins on the time line; negative: earlier"));
    shift_->setAccessibleName(shift_->toolTip());
    label->setBuddy(shift_);
    auto* align = new QToolButton;
    align->setObjectName("replayAlign");
    align->setText(tr("At the first touch"));
    align->setToolTip(tr("Shifts the other recording so that both touch the tooth first at the same moment"));
    align->setAccessibleName(align->toolTip());
    row->addWidget(otherName_, 1);
    row->addWidget(label);
    row->addWidget(shift_);
    row->addWidget(align);
    connect(shift_, &QDoubleSpinBox::valueChanged, this, &ReplayBar::shiftChosen);
    connect(align, &QToolButton::clicked, this, &ReplayBar::alignWanted);
    return widget;
}

void ReplayBar::addSideBySide(QAction& action) {
    auto* button = new QToolButton;
    button->setObjectName("replaySideBySideButton");
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setDefaultAction(&action);
    auto* row = static_cast<QBoxLayout*>(layout()->itemAt(1)->layout());
    row->insertWidget(row->indexOf(compare_) + 1, button);
}

void ReplayBar::show(const ReplayCursor& cursor) {
    slider_->setLength(cursor.length(), cursor.ready());
    slider_->show(cursor.time());
    const QString text = QString("%1 / %2").arg(clockText(cursor.time()), clockText(cursor.length()));
    if (text != time_->text()) time_->setText(text);
    const QString play = cursor.isPlaying() ? tr("Pause") : tr("Play");
    if (play != play_->text()) play_->setText(play);
}

void ReplayBar::showNote(const QString& text) {
    if (text == note_->text()) return;
    note_->setText(text);
    note_->setToolTip(text.toHtmlEscaped());
}

void ReplayBar::showOther(const QString& name, double shift) {
    compare_->setChecked(!name.isEmpty());
    otherRow_->setVisible(!name.isEmpty());
    otherName_->setText(tr("Other recording: %1").arg(name));
    const QSignalBlocker quiet(shift_);
    shift_->setValue(shift);
}

}  // namespace tactooth
