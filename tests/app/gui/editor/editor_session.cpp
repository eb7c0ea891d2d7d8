// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/editor_session.h"

#include <QAbstractButton>
#include <QAction>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>

namespace tactooth::test {

void EditorSession::openEditorWindow() {
    qputenv("XDG_DATA_HOME", (folder_ / "data").c_str());
    openWindowWithSettings();
    waitForTooth();
}

void EditorSession::chooseEntry(const char* menu, const char* entry) {
    auto* shown = window_->findChild<QMenu*>(menu);
    QMenuBar& bar = *window_->menuBar();
    QTest::mouseClick(&bar, Qt::LeftButton, {}, bar.actionGeometry(shown->menuAction()).center());
    QTRY_VERIFY_WITH_TIMEOUT(shown->isVisible(), kPatience);
    auto* action = window_->findChild<QAction*>(entry);
    QTest::mouseClick(shown, Qt::LeftButton, {}, shown->actionGeometry(action).center());
}

void EditorSession::click(const char* button) const {
    auto* found = window_->findChild<QAbstractButton*>(button);
    QVERIFY2(found != nullptr, button);
    for (QWidget* parent = found->parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(parent)) area->ensureWidgetVisible(found);
    }
    QVERIFY2(found->isVisible() && found->isEnabled(), button);
    QTest::mouseClick(found, Qt::LeftButton, {}, QPoint(12, found->height() / 2));
}

void EditorSession::waitForEditor() {
    QTRY_VERIFY_WITH_TIMEOUT(window_->editor().isEditing(), kLoadPatience);
    waitForTooth();
}

void EditorSession::setNumber(const char* name, double value) const {
    auto* box = window_->findChild<QDoubleSpinBox*>(name);
    QVERIFY2(box != nullptr && box->isEnabled(), name);
    box->selectAll();
    QTest::keyClicks(box, box->locale().toString(value));
    QTest::keyClick(box, Qt::Key_Return);
}

void EditorSession::answer(QMessageBox::StandardButton button) const {
    QTRY_VERIFY_WITH_TIMEOUT(question() != nullptr && question()->isVisible(), kPatience);
    QTest::mouseClick(question()->button(button), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(question() == nullptr, kPatience);
}

}  // namespace tactooth::test
