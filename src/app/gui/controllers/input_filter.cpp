// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/input_filter.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QWidget>

#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/panels/drive_panel.h"

namespace tactooth {

namespace {

/// A letter or space for a text field. Boxes with numbers need no space.
bool isTyped(const QObject& widget, const QKeyEvent& key) {
    const auto* line = qobject_cast<const QLineEdit*>(&widget);
    return line != nullptr && !line->isReadOnly() && qobject_cast<const QAbstractSpinBox*>(line->parent()) == nullptr &&
           !key.text().isEmpty();
}

}  // namespace

InputFilter::InputFilter(QWidget& window, DrivePanel& drive, GuidedTour& tour)
    : window_(window), drive_(drive), tour_(tour) {
    qApp->installEventFilter(this);
}

bool InputFilter::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::MouseButtonPress) tour_.stop();
    if (isKey || event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseMove) emit userActive();
    // The window in front gets the key's release.
    if (watched == &window_ && event->type() == QEvent::WindowDeactivate && !tour_.isRunning()) {
        drive_.setKeyDown(false);
    }
    if (!isKey || !watched->isWidgetType() || static_cast<QWidget*>(watched)->window() != &window_) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() != pedalKey_ || (event->type() == QEvent::KeyPress && isTyped(*watched, *key))) return false;
    if (!key->isAutoRepeat()) drive_.setKeyDown(event->type() == QEvent::KeyPress);
    return true;
}

}  // namespace tactooth
