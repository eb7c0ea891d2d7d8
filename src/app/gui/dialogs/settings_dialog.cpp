// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/settings_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>

#include "app/gui/settings/messages.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

const MessageText& titleOf(SettingsPage page) {
    switch (page) {
        case SettingsPage::Appearance:
            return msg::kSettingsPageAppearance;
        case SettingsPage::View:
            return msg::kSettingsPageView;
        case SettingsPage::Instruments:
            return msg::kSettingsPageInstruments;
        case SettingsPage::Force:
            return msg::kSettingsPageForce;
        case SettingsPage::Hand:
            return msg::kSettingsPageHand;
        case SettingsPage::Sound:
            return msg::kSettingsPageSound;
        case SettingsPage::Recording:
        case SettingsPage::None:
            break;
    }
    return msg::kSettingsPageRecording;
}

}  // namespace

SettingsDialog::SettingsDialog(const WindowSettings& now, const std::map<std::string, SettingChoices>& choices,
                               QWidget* parent)
    : QDialog(parent), settings_(now), names_(new QListWidget), stack_(new QStackedWidget) {
    setWindowTitle(tr("Settings"));
    setAttribute(Qt::WA_DeleteOnClose);
    names_->setObjectName("settingsPages");
    names_->setAccessibleName(tr("Pages"));
    auto* grid = new QGridLayout(this);
    grid->addWidget(names_, 0, 0);
    grid->addWidget(stack_, 0, 1);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(0, 1);
    for (const SettingsPage page :
         {SettingsPage::Appearance, SettingsPage::View, SettingsPage::Instruments, SettingsPage::Force,
          SettingsPage::Hand, SettingsPage::Sound, SettingsPage::Recording}) {
        addPage(page, choices);
    }
    auto* note =
        new QLabel(tr("A change acts at once. Another language opens the window anew, with the work as it is."));
    note->setWordWrap(true);
    grid->addWidget(note, 1, 0, 1, 2);
    addButtons();
    connect(names_, &QListWidget::currentRowChanged, stack_, &QStackedWidget::setCurrentIndex);
    names_->setCurrentRow(0);
    names_->setFixedWidth(names_->sizeHintForColumn(0) + 3 * fontMetrics().averageCharWidth() +
                          2 * names_->frameWidth());
    constexpr double kShare = 0.9;  // of the screen at most
    const int height = fontMetrics().height();
    resize(QSize(names_->width() + 42 * height, 36 * height).boundedTo(kShare * parent->screen()->availableSize()));
    names_->setFocus();
}

void SettingsDialog::addPage(SettingsPage page, const std::map<std::string, SettingChoices>& choices) {
    names_->addItem(translated(titleOf(page)));
    auto* inner = new QWidget;
    auto* rows = new QGridLayout(inner);
    rows->setColumnStretch(0, 1);
    rows->setHorizontalSpacing(2 * fontMetrics().averageCharWidth());
    Page made{page, {}};
    for (const WindowOption& option : windowOptions()) {
        if (option.page != page) continue;
        const auto found = choices.find(flagOf(option));
        auto* row = new SettingRow(option, found == choices.end() ? SettingChoices() : found->second, *rows);
        row->setParent(this);
        row->show(settings_);
        connect(row, &SettingRow::changed, this, [this, row] {
            row->store(settings_);
            emit changed();
        });
        made.rows.push_back(row);
    }
    rows->setRowStretch(rows->rowCount(), 1);
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(inner);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setMinimumWidth(inner->minimumSizeHint().width() + area->verticalScrollBar()->sizeHint().width());
    stack_->addWidget(area);
    pages_.push_back(std::move(made));
}

void SettingsDialog::addButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* keys = buttons->addButton(tr("&Keys…"), QDialogButtonBox::ActionRole);
    auto* page = buttons->addButton(tr("Reset this &page"), QDialogButtonBox::ResetRole);
    auto* all = buttons->addButton(tr("Reset &all"), QDialogButtonBox::ResetRole);
    keys->setObjectName("settingsKeys");
    page->setObjectName("resetPage");
    all->setObjectName("resetAll");
    for (auto* const button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
    connect(keys, &QPushButton::clicked, this, [this] {
        accept();
        emit keysWanted();
    });
    connect(page, &QPushButton::clicked, this,
            [this] { reset({&pages_[static_cast<std::size_t>(names_->currentRow())]}); });
    connect(all, &QPushButton::clicked, this, [this] {
        std::vector<Page*> every;
        for (Page& each : pages_) every.push_back(&each);
        reset(every);
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    static_cast<QGridLayout*>(layout())->addWidget(buttons, 2, 0, 1, 2);
}

/// All at once, so that the window changes once.
void SettingsDialog::reset(const std::vector<Page*>& pages) {
    for (const Page* page : pages) {
        for (SettingRow* row : page->rows) {
            row->showUsual();
            row->store(settings_);
        }
    }
    emit changed();
}

}  // namespace tactooth
