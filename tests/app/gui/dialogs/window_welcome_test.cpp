// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page at the start: its ways, the language, recent work with pictures, and the exercises.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>

#include "app/gui/dialogs/card_list.h"
#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/dialogs/welcome_dialog.h"
#include "app/gui/manual/manual_window.h"
#include "app/gui/model/thumbnail_store.h"
#include "app/gui/settings/window_setup.h"
#include "app/gui/text/translation.h"
#include "app/gui/window/window_owner.h"
#include "app/window_session.h"
#include "assessment/exercise.h"

namespace tactooth {

class WindowWelcomeTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Pictures to look at.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void aKeyAndBothMenusOpenIt();
    void itsWaysLeadOn();
    void everyExerciseHasACardUnderItsHeading();
    void aClickOnACardBeginsTheExercise();
    void enterTakesTheCardThatArrowsChose();
    void aSavedToothIsRecentWorkWithItsPicture();
    void aRecordingThatEndedIsRecentWorkWithItsPicture();
    void theCheckBoxIsKept();
    void anotherLanguageKeepsThePageOpen();
    void theKeyToQuitClosesTheWindowToo();
    void cleanupTestCase();

private:
    [[nodiscard]] WelcomeDialog* page() const { return window_->findChild<WelcomeDialog*>(); }
    [[nodiscard]] CardList* cards(const char* name) const { return page()->findChild<CardList*>(name); }
    void open() {
        window_->welcome().open();
        QVERIFY(page() != nullptr);
        QVERIFY(QTest::qWaitForWindowExposed(page(), kPatience));
    }
    void leave() {
        QTest::keyClick(page(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(page() == nullptr, kPatience);
    }
    void click(CardList& list, int card) {
        QListWidgetItem* item = list.itemOf(card);
        list.scrollToItem(item);
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(item).center());
    }
    /// The card of a file among recent work; -1: it has none.
    [[nodiscard]] int cardOf(const QString& file) const {
        CardList* list = cards("recentWork");
        for (int i = 0; list != nullptr && i < list->cards(); ++i) {
            if (list->itemOf(i)->toolTip() == file) return i;
        }
        return -1;
    }
};

void WindowWelcomeTest::initTestCase() {
    qputenv("XDG_CACHE_HOME", (folder_ / "cache").c_str());
    openWindowWithSettings();
    window_->recordings().setFolder(folder_ / "recordings");
    waitForTooth();
}

void WindowWelcomeTest::cleanupTestCase() { closeWindow(); }

void WindowWelcomeTest::aKeyAndBothMenusOpenIt() {
    key(Qt::Key_N, Qt::ControlModifier);
    QVERIFY(page() != nullptr);
    leave();
    auto* entry = window_->findChild<QAction*>("welcomeEntry");
    QVERIFY(window_->findChild<QMenu*>("helpMenu")->actions().contains(entry));
    for (const char* name : {"welcomeEntry", "chooseExercise"}) {
        window_->findChild<QAction*>(name)->trigger();
        QVERIFY2(page() != nullptr, name);
        leave();
    }
}

void WindowWelcomeTest::itsWaysLeadOn() {
    const auto choose = [&](const char* name) {
        open();
        QTest::mouseClick(page()->findChild<QPushButton*>(name), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(page() == nullptr, kPatience);
    };
    choose("practise");
    choose("openMine");
    auto* dialog = window_->findChild<QFileDialog*>();  // of the import
    QVERIFY(dialog != nullptr);
    QVERIFY2(dialog->windowTitle().contains("scan"), qPrintable(dialog->windowTitle()));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() == nullptr, kPatience);
    choose("readManual");
    QTRY_VERIFY_WITH_TIMEOUT(window_->manual().manual() != nullptr && window_->manual().manual()->isVisible(),
                             kPatience);
    window_->manual().close();
    choose("demonstration");
    auto* tour = window_->findChild<GuidedTour*>();
    QVERIFY(tour->isRunning());
    QTest::mouseClick(&view(), Qt::RightButton, {}, middle());
    QVERIFY(!tour->isRunning());
}

void WindowWelcomeTest::everyExerciseHasACardUnderItsHeading() {
    open();
    CardList& list = *cards("exercises");
    QCOMPARE(list.cards(), static_cast<int>(exercises().size()));
    for (int i = 0; i < list.cards(); ++i) {
        const Exercise& exercise = *exercises()[static_cast<std::size_t>(i)];
        const QListWidgetItem* item = list.itemOf(i);
        QCOMPARE(item->text(), exerciseTitle(exercise));
        QVERIFY2(!item->toolTip().isEmpty(), qPrintable(item->text()));
        int row = list.row(item);
        while (list.item(row)->flags() != Qt::NoItemFlags) --row;
        QCOMPARE(list.item(row)->text(), translated(titleOf(exercise.group)));
    }
    leave();
}

void WindowWelcomeTest::aClickOnACardBeginsTheExercise() {
    open();
    int pit = 0;
    while (exercises()[static_cast<std::size_t>(pit)]->id != "pit-46") ++pit;
    click(*cards("exercises"), pit);
    QTRY_VERIFY_WITH_TIMEOUT(page() == nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() != nullptr, kLoadPatience);
    QCOMPARE(window_->exercise().active()->id, std::string("pit-46"));
}

void WindowWelcomeTest::enterTakesTheCardThatArrowsChose() {
    open();
    CardList& list = *cards("exercises");
    list.setFocus();
    QCOMPARE(list.currentItem(), list.itemOf(0));
    QTest::keyClick(&list, Qt::Key_Right);
    QTest::keyClick(&list, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(page() == nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(
        window_->exercise().active() != nullptr && window_->exercise().active()->id == exercises()[1]->id,
        kLoadPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isBusy() && window_->model().runner() != nullptr, kLoadPatience);
}

void WindowWelcomeTest::aSavedToothIsRecentWorkWithItsPicture() {
    loadMolar();
    QVERIFY(waitForQuietPicture());
    QVERIFY(QTest::qWaitFor([&] { return view().isAtRest(); }, kPatience));
    const QString file = QString::fromStdString((folder_ / "mine.tactooth").string());
    waitForSteps(30);  // some tenths of a second: the picture is taken
    window_->teeth().saveTooth(file);
    waitForFiles();
    const QImage thumbnail = ThumbnailStore().load(file);
    QVERIFY(!thumbnail.isNull());
    // The tooth stands in the middle of the dark picture.
    const QColor middle = thumbnail.pixelColor(thumbnail.rect().center()), corner = thumbnail.pixelColor(2, 2);
    QVERIFY2(middle.lightness() > corner.lightness() + 60, qPrintable(middle.name() + ' ' + corner.name()));
    open();
    const int card = cardOf(file);
    QVERIFY(card >= 0);
    QCOMPARE(cards("recentWork")->itemOf(card)->text(), QString("mine"));
    click(*cards("recentWork"), card);
    QTRY_VERIFY_WITH_TIMEOUT(page() == nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->teeth().source().outer == file.toStdString(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isBusy() && window_->model().runner() != nullptr, kLoadPatience);
}

void WindowWelcomeTest::aRecordingThatEndedIsRecentWorkWithItsPicture() {
    loadMolar();
    cutALittle();
    QVERIFY(waitForQuietPicture());
    waitForSteps(30);
    loadMolar();  // another one: the recording of the first ends
    const auto recorded = [&] { return window_->recordings().folder().finished(); };
    QTRY_VERIFY_WITH_TIMEOUT(!recorded().empty(), kLoadPatience);
    const QString file = QString::fromStdString(recorded().front().string());
    QTRY_VERIFY_WITH_TIMEOUT(!ThumbnailStore().load(file).isNull(), kPatience);
    open();
    QVERIFY(cardOf(file) >= 0);
    leave();
}

void WindowWelcomeTest::theCheckBoxIsKept() {
    open();
    auto* box = page()->findChild<QCheckBox*>("welcomeAtStart");
    QVERIFY(box->isChecked());
    box->click();
    leave();
    QVERIFY(!window_->settings().welcome);
    open();
    QVERIFY(!page()->findChild<QCheckBox*>("welcomeAtStart")->isChecked());
    page()->findChild<QCheckBox*>("welcomeAtStart")->click();
    leave();
    QVERIFY(window_->settings().welcome);
}

/// The owner makes another window, where the page opens again.
void WindowWelcomeTest::anotherLanguageKeepsThePageOpen() {
    auto& application = *qobject_cast<QApplication*>(QApplication::instance());
    OpenAlOutput sound;
    WindowOwner owner(application, sound);
    const QPointer<MainWindow> first = &owner.open({});
    first->show();
    first->teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    first->welcome().open();
    auto* languages = first->findChild<QComboBox*>("welcomeLanguage");
    languages->setFocus();
    QTest::keyClick(languages, Qt::Key_End);  // the last one: Japanese
    QTRY_VERIFY_WITH_TIMEOUT(first == nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(owner.window().welcome().isOpen(), kPatience);
    QCOMPARE(owner.window().settings().language, std::string("ja"));
    QCOMPARE(owner.window().findChild<QPushButton*>("practise")->text(), QStringLiteral("練習する"));
    applyLanguage(application, "en");
}

void WindowWelcomeTest::theKeyToQuitClosesTheWindowToo() {
    auto& application = *qobject_cast<QApplication*>(QApplication::instance());
    OpenAlOutput sound;
    WindowOwner owner(application, sound);
    MainWindow& window = owner.open({});
    window.show();
    window.welcome().open();
    auto* page = window.findChild<WelcomeDialog*>();
    QVERIFY(QTest::qWaitForWindowActive(page, kPatience));
    QTest::keyClick(page, Qt::Key_Q, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!window.isVisible(), kPatience);
}

void WindowWelcomeTest::savePictures(const QString& folder) {
    initTestCase();
    open();
    page()->grab().save(folder + "/welcome-new.png");
    leave();
    aSavedToothIsRecentWorkWithItsPicture();
    aRecordingThatEndedIsRecentWorkWithItsPicture();
    open();
    page()->grab().save(folder + "/welcome.png");
    leave();
    applyColours(true);
    open();
    page()->grab().save(folder + "/welcome-dark.png");
    leave();
    closeWindow();
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowWelcomeTest test;
    if (argc == 3 && QString(argv[1]) == "--pictures") {
        test.savePictures(argv[2]);
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}
#include "window_welcome_test.moc"
