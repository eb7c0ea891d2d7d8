// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/keys/key_binding.h"
#include "app/gui/replay/replay_cursor.h"

namespace tactooth {
namespace {

/// 3:07.25
QString clockText(double time) {
    const auto hundredths = static_cast<qlonglong>(time * 100);
    return QString("%1:%2.%3")
        .arg(hundredths / 6000)
        .arg(hundredths / 100 % 60, 2, 10, QChar('0'))
        .arg(hundredths % 100, 2, 10, QChar('0'));
}

}  // namespace

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
    connect(addButton("replayPrevious", "⏮", tr("To the event or comment before"), KeyId::ReplayPrevious),
            &QToolButton::clicked, this, &ReplayBar::previousWanted);
    connect(addButton("replayBack", "◂", tr("Back by one tick"), KeyId::ReplayBack), &QToolButton::clicked, this,
            [this] { emit stepped(-1); });
    connect(addButton("replayOn", "▸", tr("On by one tick"), KeyId::ReplayOn), &QToolButton::clicked, this,
            [this] { emit stepped(1); });
    connect(addButton("replayNext", "⏭", tr("To the next event or comment"), KeyId::ReplayNext), &QToolButton::clicked,
            this, &ReplayBar::nextWanted);
    addSpeeds();
    addComments();
    compare_ =
        addButton("replayCompare", tr("Compare…"), tr("Shows another recording as a blue ghost in this one"), {});
    compare_->setCheckable(true);
    connect(compare_, &QToolButton::clicked, this, &ReplayBar::compareToggled);
    note_->setObjectName("replayNote");
    note_->setTextFormat(Qt::PlainText);
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    static_cast<QBoxLayout*>(layout()->itemAt(1)->layout())->addWidget(note_, 1);
    connect(addButton("replayLeave", tr("Leave replay"), tr("Back to the tooth as it was"), KeyId::ReplayLeave),
            &QToolButton::clicked, this, &ReplayBar::leaveWanted);

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

void ReplayBar::show(const ReplayCursor& cursor, double ready) {
    slider_->setLength(cursor.length(), ready);
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

void ReplayBar::setCompares(bool compares) { compare_->setChecked(compares); }

}  // namespace tactooth
