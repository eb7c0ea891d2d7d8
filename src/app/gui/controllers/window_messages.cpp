// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/window_messages.h"

#include "app/gui/panels/status_line.h"
#include "app/gui/text/translation.h"

namespace tactooth {

void WindowMessages::setHint(const QString& hint) {
    if (!isSilent_) status_.setHint(hint);
}

void WindowMessages::showError(const QString& sentence) {
    setHint(sentence);
    show(QMessageBox::Warning, tr("Tactooth"), sentence);
}

void WindowMessages::showError(const Error& error) { showError(translated(error)); }

void WindowMessages::showWritten(const Expected<bool>& written, const QString& hint) {
    if (!written) return showError(written.error());
    setHint(*written ? hint : tr("It was cancelled: no file was written or changed"));
}

void WindowMessages::show(QMessageBox::Icon icon, const QString& title, const QString& text) {
    if (isSilent_) return;
    auto* box = new QMessageBox(icon, title, text, QMessageBox::Ok, &window_);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse);
    box->open();
}

}  // namespace tactooth
