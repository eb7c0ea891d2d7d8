// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The manual in its window: opened by the key of the help, searched, and read beside the work.
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>

#include "app/gui/controllers/manual_controller.h"
#include "app/gui/dialogs/key_editor.h"
#include "app/gui/manual/manual_window.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"

namespace tactooth {

class WindowManualTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Saves pictures of the manual: light, dark with hits, Japanese.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void cleanup();
    void theHelpKeyExplainsWhatHasTheFocus();
    void aDialogIsExplainedAndLeavesTheManualFree();
    void linksLeadOnAndBack();
    void allPagesAreSearched();
    void thePageOfTheKeysShowsTheKeysOfNow();
    void inJapanesePagesAreJapaneseOrSaySo();
    void escapeReturnsToTheWork();
    void theProgramEndsWithItsOwnWindow();

private:
    [[nodiscard]] ManualWindow& manual() const { return *window_->manual().manual(); }
    [[nodiscard]] bool isOpen() const { return window_->manual().manual() != nullptr && manual().isVisible(); }
    /// Presses the key where the focus is.
    void help(QWidget& focus) const;
};

void WindowManualTest::initTestCase() {
    openWindowWithSettings();
    waitForTooth();
}

void WindowManualTest::cleanup() {
    if (window_ != nullptr) window_->manual().close();
}

void WindowManualTest::help(QWidget& focus) const {
    QApplication::setActiveWindow(focus.window());
    focus.setFocus();
    QTest::keyClick(&focus, Qt::Key_F1);
}

void WindowManualTest::theHelpKeyExplainsWhatHasTheFocus() {
    help(view());
    QVERIFY(isOpen());
    QCOMPARE(manual().browser().page(), QString("user/keys.md"));
    auto* exercises = window_->findChild<QComboBox*>("exercise");
    for (QWidget* each = exercises; each != nullptr; each = each->parentWidget()) each->show();
    help(*exercises);
    QCOMPARE(manual().browser().page(), QString("user/first-ten-minutes.md"));
    QVERIFY(manual().browser().textCursor().block().text().contains("exercise"));
    QVERIFY(manual().browser().verticalScrollBar()->value() > 0);
}

/// The dialog locks the window behind it, but not the manual.
void WindowManualTest::aDialogIsExplainedAndLeavesTheManualFree() {
    for (QAction* action : window_->findChildren<QAction*>()) {
        if (action->text() == "&Keys…") action->trigger();
    }
    auto* editor = window_->findChild<KeyEditor*>();
    help(*editor->findChild<QTreeWidget*>("keys"));
    QVERIFY(isOpen() && editor->isVisible());
    QCOMPARE(manual().browser().page(), QString("user/keys.md"));
    auto* contents = manual().findChild<QTreeWidget*>("manualContents");
    contents->scrollToItem(contents->topLevelItem(0));
    const QRect place = contents->visualItemRect(contents->topLevelItem(0));
    QTest::mouseClick(contents->viewport(), Qt::LeftButton, {}, {place.left() + 20, place.center().y()});
    QCOMPARE(manual().browser().page(), QString("user/first-ten-minutes.md"));
    QTest::keyClick(editor, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<KeyEditor*>() == nullptr, kPatience);
    QVERIFY(isOpen());
}

void WindowManualTest::linksLeadOnAndBack() {
    help(view());
    ManualBrowser& browser = manual().browser();
    browser.open("user/first-ten-minutes.md");
    QVERIFY(browser.document()->size().height() > 1000);
    emit browser.anchorClicked(QUrl("../haptics.md#devices"));
    QCOMPARE(browser.page(), QString("haptics.md"));
    QCOMPARE(browser.textCursor().block().text(), QString("Devices"));
    emit browser.anchorClicked(QUrl("decisions/0010-hand-process.md"));
    QCOMPARE(browser.page(), QString("haptics.md"));
    auto* line = manual().findChild<QLabel*>("manualLine");
    QVERIFY2(line->isVisible() && line->text().contains("0010-hand-process.md"), qPrintable(line->text()));
    QTest::mouseClick(manual().findChild<QToolButton*>("back"), Qt::LeftButton);
    QCOMPARE(browser.page(), QString("user/first-ten-minutes.md"));
    QVERIFY(!line->isVisible());
    QTest::mouseClick(manual().findChild<QToolButton*>("forward"), Qt::LeftButton);
    QCOMPARE(browser.page(), QString("haptics.md"));
    QCOMPARE(manual().findChild<QTreeWidget*>("manualContents")->currentItem()->text(0),
             manual().pages().title("haptics.md"));
}

void WindowManualTest::allPagesAreSearched() {
    help(view());
    auto* field = manual().findChild<QLineEdit*>("manualSearch");
    auto* hits = manual().findChild<QListWidget*>("manualHits");
    QTest::keyClicks(field, "UNDERCUT area, best insertion");
    QVERIFY(hits->isVisible() && hits->count() >= 1);
    hits->setCurrentRow(0);
    QCOMPARE(manual().browser().page(), QString("user/metrics.md"));
    QVERIFY(manual().browser().extraSelections().size() >= 2);
    field->setText("xyzzy plugh");
    QCOMPARE(hits->count(), 1);
    QCOMPARE(hits->item(0)->flags(), Qt::ItemFlags(Qt::NoItemFlags));
    field->clear();
    QVERIFY(!hits->isVisible() && manual().browser().extraSelections().isEmpty());
}

void WindowManualTest::thePageOfTheKeysShowsTheKeysOfNow() {
    WindowSettings settings = window_->settings();
    settings.ownKeys = "cut = Ctrl+F11";
    window_->apply(settings);
    help(view());
    QVERIFY(manual().browser().toPlainText().contains("Ctrl+F11"));
    settings.ownKeys.clear();
    window_->apply(settings);
    window_->manual().close();
    help(view());
    QVERIFY(!manual().browser().toPlainText().contains("Ctrl+F11"));
}

void WindowManualTest::inJapanesePagesAreJapaneseOrSaySo() {
    applyLanguage(*qApp, "ja");
    {
        MainWindow again(*sound_);
        again.manual().openForFocus();
        ManualBrowser& browser = again.manual().manual()->browser();
        browser.open("user/first-ten-minutes.md");
        QVERIFY(browser.toPlainText().contains(QStringLiteral("最初の10分")));
        emit browser.anchorClicked(QUrl("keys.ja.md"));
        QVERIFY(browser.toPlainText().contains(QStringLiteral("マウスとキー")));
        browser.open("user/replay.md");
        QVERIFY(browser.toPlainText().startsWith(QStringLiteral("リプレイ")));
        browser.open("user/commands.md");
        QVERIFY(browser.toPlainText().startsWith(QStringLiteral("このページはまだ英語だけです。")));
    }
    applyLanguage(*qApp, "en");
}

void WindowManualTest::escapeReturnsToTheWork() {
    help(view());
    QTest::keyClick(&manual(), Qt::Key_Escape);
    QVERIFY(!isOpen());
    key(Qt::Key_C);
    QTest::keyPress(&view(), Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().controls.pedal, 1.0, kPatience);
    QTest::keyRelease(&view(), Qt::Key_Space);
    key(Qt::Key_T);
}

void WindowManualTest::theProgramEndsWithItsOwnWindow() {
    help(view());
    QVERIFY(isOpen());
    QVERIFY(window_->close());
    const auto isVisible = [](const QWidget* widget) { return widget->isVisible(); };
    QTRY_VERIFY_WITH_TIMEOUT(std::ranges::none_of(QApplication::topLevelWidgets(), isVisible), kPatience);
    QVERIFY(!isOpen());
    closeWindow();
}

void WindowManualTest::savePictures(const QString& folder) {
    initTestCase();
    help(view());
    manual().open("user/first-ten-minutes.md", 3);
    manual().grab().save(folder + "/manual.png");
    applyColours(true);
    manual().open("user/keys.md");
    manual().findChild<QLineEdit*>("manualSearch")->setText("bur depth");
    manual().grab().save(folder + "/manual-dark.png");
    applyColours(false);
    closeWindow();
    applyLanguage(*qApp, "ja");
    openWindowWithSettings();
    window_->manual().openForFocus();
    manual().open("user/first-ten-minutes.md", 4);
    manual().grab().save(folder + "/manual-ja.png");
    manual().open("user/keys.md");
    manual().grab().save(folder + "/manual-ja-keys.png");
    closeWindow();
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowManualTest test;
    if (argc == 3 && QString(argv[1]) == "--pictures") return test.savePictures(argv[2]), 0;
    return QTest::qExec(&test, argc, argv);
}

#include "window_manual_test.moc"
