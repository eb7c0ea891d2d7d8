// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/key_editor.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/keys/key_binding.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

enum Column { kAction, kKey, kUsual };
constexpr int kRowRole = Qt::UserRole;

bool isModifier(int key) {
    return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt || key == Qt::Key_Meta;
}

/// The key that was pressed for a row of this kind; none: only a modifier yet.
Keys pressedKeys(const QKeyEvent& event, KeyKind kind) {
    const auto key = static_cast<Qt::Key>(event.key());
    const bool wantsModifier = kind == KeyKind::HandModifier || kind == KeyKind::WheelModifier;
    if (wantsModifier) return {QKeySequence(key)};
    if (isModifier(key) || key == Qt::Key_AltGr || key == Qt::Key_unknown || key == 0) return {};
    if (kind != KeyKind::Shortcut) return {QKeySequence(key == Qt::Key_Enter ? Qt::Key_Return : key)};
    Qt::KeyboardModifiers with = event.modifiers() & ~Qt::KeypadModifier;
    // Shift has made the sign itself, as "?": a shortcut with it and Shift would not be found.
    const bool isSign =
        !event.text().isEmpty() && event.text()[0].isPrint() && !event.text()[0].isLetter() && key != Qt::Key_Space;
    if (isSign) with &= ~Qt::ShiftModifier;
    return {QKeySequence(QKeyCombination(with, key))};
}

}  // namespace

KeyEditor::KeyEditor(KeyMap map, QWidget* parent)
    : QDialog(parent), map_(std::move(map)), list_(new QTreeWidget), line_(new QLabel) {
    setWindowTitle(tr("Keys"));
    setAttribute(Qt::WA_DeleteOnClose);
    list_->setObjectName("keys");
    list_->setAccessibleName(tr("Keys"));
    list_->setHeaderLabels({tr("Action"), tr("Key"), tr("Usual key")});
    list_->setRootIsDecorated(false);
    list_->setAlternatingRowColors(true);
    list_->installEventFilter(this);
    line_->setObjectName("keyLine");
    line_->setWordWrap(true);
    line_->setMinimumHeight(2 * line_->fontMetrics().lineSpacing());  // the list stays where it is
    auto* column = new QVBoxLayout(this);
    column->addWidget(list_, 1);
    column->addWidget(line_);
    addRows();
    addButtons();
    showKeys();
    connect(list_, &QTreeWidget::itemActivated, this, &KeyEditor::listen);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
        stopListening();
        showKeys();
    });
    for (const int each : {kKey, kUsual, kAction}) list_->resizeColumnToContents(each);
    constexpr double kShare = 0.85;  // of the screen at most
    constexpr int kRows = 28;
    const int width = list_->header()->length() + 4 * fontMetrics().height();
    resize(QSize(width, kRows * fontMetrics().height()).boundedTo(kShare * parent->screen()->availableSize()));
    list_->setFocus();
}

void KeyEditor::addRows() {
    QTreeWidgetItem* group = nullptr;
    for (const KeyRow& row : keyTable()) {
        const QString title = translated(titleOf(row.group));
        if (group == nullptr || group->text(kAction) != title) {
            group = new QTreeWidgetItem(list_, {title});
            QFont bold = group->font(kAction);
            bold.setBold(true);
            group->setFont(kAction, bold);
            group->setFirstColumnSpanned(true);
            group->setFlags(Qt::ItemIsEnabled);
        }
        auto* item = new QTreeWidgetItem(group, {translated(*row.text), QString(), keysText(KeyMap::usual(row.id))});
        item->setData(kAction, kRowRole, static_cast<int>(row.id));
    }
    list_->expandAll();
    list_->setItemsExpandable(false);
    list_->setCurrentItem(list_->topLevelItem(0)->child(0));
}

void KeyEditor::addButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    change_ = buttons->addButton(tr("&Change…"), QDialogButtonBox::ActionRole);
    reset_ = buttons->addButton(tr("&Usual key"), QDialogButtonBox::ActionRole);
    auto* all = buttons->addButton(tr("&All usual keys"), QDialogButtonBox::ResetRole);
    change_->setObjectName("changeKey");
    reset_->setObjectName("usualKey");
    all->setObjectName("usualKeys");
    for (auto* const button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
    connect(change_, &QPushButton::clicked, this, &KeyEditor::listen);
    connect(reset_, &QPushButton::clicked, this, &KeyEditor::resetChosen);
    connect(all, &QPushButton::clicked, this, &KeyEditor::resetAll);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout()->addWidget(buttons);
}

/// Own keys are bold.
void KeyEditor::showKeys() {
    for (QTreeWidgetItemIterator each(list_); *each != nullptr; ++each) {
        QTreeWidgetItem& item = **each;
        if (!item.data(kAction, kRowRole).isValid()) continue;
        const auto id = static_cast<KeyId>(item.data(kAction, kRowRole).toInt());
        item.setText(kKey, listening_ == id ? tr("press a key…") : keysText(map_.keys(id)));
        QFont font = list_->font();
        font.setBold(!map_.isUsual(id));
        item.setFont(kKey, font);
    }
    const std::optional<KeyId> row = chosen();
    change_->setEnabled(row.has_value());
    reset_->setEnabled(row && !map_.isUsual(*row));
}

std::optional<KeyId> KeyEditor::chosen() const {
    const QTreeWidgetItem* const item = list_->currentItem();
    if (item == nullptr || !item->data(kAction, kRowRole).isValid()) return std::nullopt;
    return static_cast<KeyId>(item->data(kAction, kRowRole).toInt());
}

void KeyEditor::listen() {
    listening_ = chosen();
    if (!listening_) return;
    line_->setText(tr("Press the new key for “%1”. A click elsewhere leaves the key as it is.")
                       .arg(translated(*keyRow(*listening_).text)));
    list_->setFocus();
    showKeys();
}

void KeyEditor::stopListening() {
    if (!std::exchange(listening_, std::nullopt)) return;
    line_->clear();
    showKeys();
}

void KeyEditor::take(const Keys& wanted) {
    const KeyId id = *listening_;
    stopListening();
    if (wanted == map_.keys(id)) return;
    if (const auto fault = map_.objection(id, wanted)) return line_->setText(translated(*fault));
    map_.set(id, wanted);
    showKeys();
    emit changed();
}

void KeyEditor::resetChosen() {
    stopListening();
    const std::optional<KeyId> row = chosen();
    if (!row) return;
    if (const auto fault = map_.objection(*row, KeyMap::usual(*row))) return line_->setText(translated(*fault));
    map_.set(*row, KeyMap::usual(*row));
    line_->clear();
    showKeys();
    emit changed();
}

void KeyEditor::resetAll() {
    stopListening();
    map_ = KeyMap();
    line_->setText(tr("All keys are the usual ones."));
    showKeys();
    emit changed();
}

/// While it listens, no key has its usual meaning.
bool KeyEditor::eventFilter(QObject* watched, QEvent* event) {
    if (!listening_) return QDialog::eventFilter(watched, event);
    if (event->type() == QEvent::FocusOut) stopListening();
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const Keys pressed = pressedKeys(key, keyRow(*listening_).kind);
    if (!key.isAutoRepeat() && !pressed.isEmpty()) take(pressed);
    return true;
}

}  // namespace tactooth
