// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/help_menu.h"

#include <QMenuBar>
#include <QTextDocument>

#include "app/gui/controllers/key_controller.h"
#include "app/gui/controllers/manual_controller.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/dialogs/text_dialog.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/keys/key_page.h"
#include "app/gui/menus/welcome_entry.h"
#include "app/gui/text/translation.h"
#include "session/io/commit.h"

namespace tactooth {

HelpMenu::HelpMenu(QMenuBar& bar, QWidget& window, const WelcomeEntry& welcome, GuidedTour& tour,
                   WindowMessages& messages, const KeyController& keys, ManualController& manual)
    : window_(window), messages_(messages), keys_(keys) {
    QMenu* menu = bar.addMenu(tr("&Help"));
    menu->setObjectName("helpMenu");
    menu->addAction(&welcome.action());
    setLineIcon(*menu->addAction(tr("Watch the &demonstration"), &tour, &GuidedTour::start), "demonstration");
    QAction* entry = menu->addAction(tr("Ma&nual"), &manual, &ManualController::openForFocus);
    bindKey(*entry, KeyId::Help);
    setLineIcon(*entry, "manual");
    setLineIcon(*menu->addAction(tr("&Mouse and keys"), this, &HelpMenu::showMouseAndKeys), "keys");
    setLineIcon(*menu->addAction(tr("&About Tactooth"), this, &HelpMenu::showAbout), "about");
}

void HelpMenu::showMouseAndKeys() {
    QTextDocument page;
    page.setMarkdown(QString::fromStdString(ownKeyPage(keys_.map(), windowLanguage())));
    (new TextDialog(tr("Mouse and keys"), page.toHtml(), &window_))->open();
}

void HelpMenu::showAbout() {
    messages_.show(QMessageBox::NoIcon, tr("About Tactooth"),
                   tr("<b>Tactooth %1</b> (%2)<br>See, feel and hear a dental bur touch and cut a tooth.<br><br>"
                      "Free software under the GNU General Public License, version 3 or later;<br>"
                      "its simulation library under the Apache License 2.0.")
                       .arg(TACTOOTH_VERSION, kCommit));
}

}  // namespace tactooth
