// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/manual_controller.h"

#include <QApplication>
#include <QKeyEvent>

#include "app/gui/controllers/key_controller.h"
#include "app/gui/dialogs/key_editor.h"
#include "app/gui/keys/key_page.h"
#include "app/gui/manual/context_help.h"
#include "app/gui/manual/manual_window.h"
#include "app/gui/text/translation.h"

namespace tactooth {

ManualController::ManualController(QWidget& window, const KeyController& keys) : window_(window), keys_(keys) {
    qApp->installEventFilter(this);
}

ManualController::~ManualController() = default;

void ManualController::openForFocus() {
    const ManualPlace place = manualPlaceFor(QApplication::focusWidget());
    if (manual_ == nullptr) {
        const Language language = windowLanguage();
        const auto keyPage = [this, language] { return ownKeyPage(keys_.map(), language); };
        manual_ = std::make_unique<ManualWindow>(ManualPages(language, keyPage), window_);
        connect(manual_.get(), &QDialog::finished, this, &ManualController::returnKeyboard);
    }
    manual_->open(place.page, place.section);
}

/// As window managers do; a kiosk has none.
void ManualController::returnKeyboard() {
    if (QApplication::activeWindow() != nullptr || QApplication::applicationState() != Qt::ApplicationActive) return;
    QWidget* const dialog = QApplication::activeModalWidget();
    (dialog != nullptr ? *dialog : window_).activateWindow();
}

void ManualController::close() {
    if (manual_ != nullptr) manual_->close();
}

bool ManualController::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || !watched->isWidgetType()) return false;
    const QWidget* const front = static_cast<QWidget*>(watched)->window();
    if (front == &window_ || front == manual_.get() || front->windowType() == Qt::Popup) return false;
    const auto* const editor = qobject_cast<const KeyEditor*>(front);
    if (editor != nullptr && editor->isListening()) return false;
    const QKeySequence pressed(static_cast<QKeyEvent*>(event)->keyCombination());
    if (!keys_.map().keys(KeyId::Help).contains(pressed)) return false;
    openForFocus();
    return true;
}

}  // namespace tactooth
