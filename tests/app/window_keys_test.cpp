// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of the window: their editor, worked by real keys, and what the settings keep of it.
#include <QApplication>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "app/gui/dialogs/key_editor.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"

namespace tactooth {

class WindowKeysTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Saves pictures of the editor: as it opens, in dark colours after a refusal, in Japanese.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void cleanup();
    void anotherKeyDoesTheSame();
    void aKeyInUseIsRefusedAndNamed();
    void oneKeyAndAllKeysBecomeUsualAgain();
    void thePictureObeysOwnKeys();
    void aModifierOfTheWheelCanBeChanged();
    void thePedalKeyIsTheSameInPanelAndEditor();
    void ownKeysAreKept();
    void damagedKeysGiveOneMessageAndTheUsualKeys();
    void cleanupTestCase();

private:
    KeyEditor* open();
    static void choose(const KeyEditor& editor, KeyId id);
    /// Chooses the row and presses its new key.
    static void give(const KeyEditor& editor, KeyId id, Qt::Key key, Qt::KeyboardModifiers with = {});
    static QString line(const KeyEditor& editor) { return editor.findChild<QLabel*>("keyLine")->text(); }
    void leave(KeyEditor* editor);
    [[nodiscard]] bool isCutting() const { return window_->findChild<DrillBar*>()->isCutting(); }
};

void WindowKeysTest::initTestCase() {
    openWindowWithSettings();
    waitForTooth();
}

void WindowKeysTest::cleanupTestCase() { closeWindow(); }

void WindowKeysTest::cleanup() {
    WindowSettings settings = window_->settings();
    settings.ownKeys.clear();
    settings.hand.pedalKey = "Space";
    window_->apply(settings);
    while (!dismissMessage().isEmpty()) continue;
    key(Qt::Key_T);
}

KeyEditor* WindowKeysTest::open() {
    for (QAction* action : window_->findChildren<QAction*>()) {
        if (action->text() == "&Keys…") action->trigger();
    }
    auto* editor = window_->findChild<KeyEditor*>();
    if (editor != nullptr) QApplication::setActiveWindow(editor);
    return editor;
}

void WindowKeysTest::choose(const KeyEditor& editor, KeyId id) {
    auto* list = editor.findChild<QTreeWidget*>("keys");
    for (QTreeWidgetItemIterator each(list); *each != nullptr; ++each) {
        const QVariant row = (*each)->data(0, Qt::UserRole);
        if (row.isValid() && row.toInt() == static_cast<int>(id)) list->setCurrentItem(*each);
    }
}

void WindowKeysTest::give(const KeyEditor& editor, KeyId id, Qt::Key key, Qt::KeyboardModifiers with) {
    choose(editor, id);
    QTest::mouseClick(editor.findChild<QPushButton*>("changeKey"), Qt::LeftButton);
    QTest::keyClick(editor.findChild<QTreeWidget*>("keys"), key, with);
}

void WindowKeysTest::leave(KeyEditor* editor) {
    QTest::keyClick(editor, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<KeyEditor*>() == nullptr, kPatience);
}

void WindowKeysTest::anotherKeyDoesTheSame() {
    KeyEditor* editor = open();
    QVERIFY(editor != nullptr && editor->isVisible());
    give(*editor, KeyId::Cut, Qt::Key_F11);
    leave(editor);
    key(Qt::Key_C);
    QVERIFY(!isCutting());
    key(Qt::Key_F11);
    QVERIFY(isCutting());
    const QAction* cut = window_->findChild<DrillBar*>()->cutAction();
    QVERIFY2(cut->toolTip().contains("(F11)"), qPrintable(cut->toolTip()));
}

void WindowKeysTest::aKeyInUseIsRefusedAndNamed() {
    KeyEditor* editor = open();
    give(*editor, KeyId::Cut, Qt::Key_T);
    QVERIFY2(line(*editor).contains("Touch"), qPrintable(line(*editor)));
    QVERIFY(editor->map().isUsual(KeyId::Cut));
    give(*editor, KeyId::Cut, Qt::Key_Left, Qt::ControlModifier);  // turns the tooth
    QVERIFY2(line(*editor).contains("Ctrl+Left"), qPrintable(line(*editor)));
    give(*editor, KeyId::Cut, Qt::Key_F11);
    QCOMPARE(line(*editor), QString());
    QVERIFY(!editor->map().isUsual(KeyId::Cut));
    leave(editor);
}

void WindowKeysTest::oneKeyAndAllKeysBecomeUsualAgain() {
    KeyEditor* editor = open();
    give(*editor, KeyId::Cut, Qt::Key_F11);
    give(*editor, KeyId::Touch, Qt::Key_C);
    auto* usual = editor->findChild<QPushButton*>("usualKey");
    choose(*editor, KeyId::Fit);
    QVERIFY(!usual->isEnabled());
    choose(*editor, KeyId::Cut);
    QVERIFY(usual->isEnabled());
    QTest::mouseClick(usual, Qt::LeftButton);  // C is the key of Touch now
    QVERIFY2(line(*editor).contains("Touch") && !editor->map().isUsual(KeyId::Cut), qPrintable(line(*editor)));
    choose(*editor, KeyId::Touch);
    QTest::mouseClick(usual, Qt::LeftButton);
    QVERIFY(editor->map().isUsual(KeyId::Touch));
    QTest::mouseClick(editor->findChild<QPushButton*>("usualKeys"), Qt::LeftButton);
    QVERIFY(editor->map().isUsual(KeyId::Cut));
    leave(editor);
    QVERIFY(window_->settings().ownKeys.empty());
    key(Qt::Key_C);
    QVERIFY(isCutting());
}

void WindowKeysTest::thePictureObeysOwnKeys() {
    KeyEditor* editor = open();
    give(*editor, KeyId::MoveLeft, Qt::Key_Semicolon);
    give(*editor, KeyId::Press, Qt::Key_N);
    leave(editor);
    QApplication::setActiveWindow(window_.get());
    view().setFocus();
    const auto aimed = [this] { return window_->model().manipulator().landing(); };
    QTest::mouseMove(&view(), middle() + QPoint(0, 80));  // on the tooth
    QTest::keyClick(&view(), Qt::Key_Right);
    QVERIFY(aimed().has_value());
    const Vec3 before = *aimed();
    QTest::keyClick(&view(), Qt::Key_Left);
    QCOMPARE((*aimed() - before).norm(), 0.0);
    QTest::keyClick(&view(), Qt::Key_Semicolon);
    QVERIFY((*aimed() - before).norm() > 0.01);
    QTest::keyPress(&view(), Qt::Key_Return);
    QVERIFY(!window_->model().manipulator().isPressing());
    QTest::keyPress(&view(), Qt::Key_N);
    QVERIFY(window_->model().manipulator().isPressing());
    QTest::keyRelease(&view(), Qt::Key_N);
    QVERIFY(!window_->model().manipulator().isPressing());
}

void WindowKeysTest::aModifierOfTheWheelCanBeChanged() {
    KeyEditor* editor = open();
    give(*editor, KeyId::Zoom, Qt::Key_Alt);
    give(*editor, KeyId::Zoom, Qt::Key_J);
    QVERIFY2(line(*editor).contains("Shift, Ctrl, Alt or Meta"), qPrintable(line(*editor)));
    leave(editor);
    const auto turn = [this](Qt::KeyboardModifiers with) {
        QWheelEvent wheel(view().rect().center(), view().mapToGlobal(view().rect().center()), {}, QPoint(0, 120), {},
                          with, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view(), &wheel);
    };
    const double before = view().orbitCamera().distance();
    turn(Qt::ControlModifier);
    QCOMPARE(view().orbitCamera().distance(), before);
    turn(Qt::AltModifier);
    QVERIFY(view().orbitCamera().distance() < before);
    key(Qt::Key_0);
}

void WindowKeysTest::thePedalKeyIsTheSameInPanelAndEditor() {
    auto* shown = window_->findChild<QKeySequenceEdit*>("pedalKey");
    KeyEditor* editor = open();
    give(*editor, KeyId::Pedal, Qt::Key_F8);
    leave(editor);
    QCOMPARE(shown->keySequence(), QKeySequence(Qt::Key_F8));
    QCOMPARE(window_->settings().hand.pedalKey, std::string("F8"));
    QTest::keyPress(&view(), Qt::Key_F8);
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().controls.pedal, 1.0, kPatience);
    QTest::keyRelease(&view(), Qt::Key_F8);
    shown->setKeySequence(QKeySequence(Qt::Key_C));
    emit shown->editingFinished();
    const QString refusal = dismissMessage();
    QVERIFY2(refusal.contains("Cut"), qPrintable(refusal));
    QCOMPARE(shown->keySequence(), QKeySequence(Qt::Key_F8));
    shown->setKeySequence(QKeySequence(Qt::Key_F9));
    emit shown->editingFinished();
    editor = open();
    QCOMPARE(editor->map().key(KeyId::Pedal), Qt::Key_F9);
    leave(editor);
}

void WindowKeysTest::ownKeysAreKept() {
    KeyEditor* editor = open();
    give(*editor, KeyId::Cut, Qt::Key_F11);
    give(*editor, KeyId::Redo, Qt::Key_Y, Qt::AltModifier | Qt::ControlModifier);
    leave(editor);
    const auto file = folder_ / "window.toml";
    QVERIFY(writeWindowSettings(window_->settings(), file).has_value());
    const auto read = readWindowSettings(file);
    QVERIFY(read.has_value() && read->refused.empty());
    MainWindow again(*sound_);
    again.apply(*read);
    QCOMPARE(again.findChild<DrillBar*>()->cutAction()->shortcut(), QKeySequence("F11"));
    QCOMPARE(again.findChild<DrillBar*>()->redoAction()->shortcuts(), QList<QKeySequence>{QKeySequence("Ctrl+Alt+Y")});
    QCOMPARE(again.settings().ownKeys, window_->settings().ownKeys);
}

void WindowKeysTest::damagedKeysGiveOneMessageAndTheUsualKeys() {
    WindowSettings settings = window_->settings();
    settings.ownKeys = "cut = Hyper+Q\nfly = F12\ntouch = F11";
    window_->apply(settings);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    QCOMPARE(window_->findChildren<QMessageBox*>().size(), 1);
    const QString said = dismissMessage();
    QVERIFY2(said.contains("Hyper+Q") && said.contains("fly"), qPrintable(said));
    key(Qt::Key_C);
    QVERIFY(isCutting());
    key(Qt::Key_F11);  // the line that is right counts
    QVERIFY(!isCutting());
    QCOMPARE(window_->settings().ownKeys, std::string("touch = F11"));
}

void WindowKeysTest::savePictures(const QString& folder) {
    initTestCase();
    KeyEditor* editor = open();
    editor->grab().save(folder + "/keys.png");
    applyColours(true);
    give(*editor, KeyId::Fit, Qt::Key_F11);
    give(*editor, KeyId::Cut, Qt::Key_T);
    editor->grab().save(folder + "/keys-dark.png");
    leave(editor);
    applyColours(false);
    closeWindow();
    applyLanguage(*qApp, "ja");
    openWindowWithSettings();
    KeyEditor japanese({}, window_.get());
    japanese.show();
    japanese.grab().save(folder + "/keys-ja.png");
    closeWindow();
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowKeysTest test;
    if (argc == 3 && QString(argv[1]) == "--pictures") return test.savePictures(argv[2]), 0;
    return QTest::qExec(&test, argc, argv);
}

#include "window_keys_test.moc"
