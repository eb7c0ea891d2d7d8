// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tooth chart: how it is opened, what it shows, and how a tooth is chosen in it.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QToolBar>
#include <QToolButton>
#include <cmath>

#include "app/gui/dialogs/tooth_button.h"
#include "app/gui/dialogs/tooth_chart_dialog.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "instruments/builtin_tooth.h"

namespace tactooth {

class WindowChartTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Pictures to look at.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void aKeyTheMenuAndTheToolBarOpenIt();
    void theToolBarShowsTheToothOnTheBench();
    void everyToothHasANameATooltipAndAPlaceOfItsOwn();
    void itMarksTheLoadedToothAndThoseWithExercises();
    void anotherNotationIsShownAndKept();
    void arrowsAndTypedNumbersGoToATooth();
    void enterTakesTheTooth();
    void aClickTakesTheTooth();
    void leavingItChangesNothing();
    void itIsLegibleInBothColoursAndLanguages();
    void cleanupTestCase();

private:
    [[nodiscard]] ToothChartDialog* chart() const { return window_->findChild<ToothChartDialog*>(); }
    [[nodiscard]] ToothButton& tooth(int fdi) const {
        return *chart()->findChild<ToothButton*>(QString("tooth%1").arg(fdi));
    }
    [[nodiscard]] QAction& entry() const { return *window_->findChild<QAction*>("toothChartEntry"); }
    [[nodiscard]] int focused() const {
        const auto* now = qobject_cast<ToothButton*>(chart()->focusWidget());
        return now != nullptr ? now->fdi() : 0;
    }
    void open();
    void leave();
    void press(Qt::Key key) { QTest::keyClick(chart()->focusWidget(), key); }
};

void WindowChartTest::initTestCase() {
    openWindowWithSettings();
    waitForTooth();
}

void WindowChartTest::cleanupTestCase() { closeWindow(); }

void WindowChartTest::open() {
    key(Qt::Key_T, Qt::ControlModifier);
    QVERIFY(chart() != nullptr);
    QVERIFY(QTest::qWaitForWindowExposed(chart(), kPatience));
}

void WindowChartTest::leave() {
    QTest::keyClick(chart(), Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(chart() == nullptr, kPatience);
}

void WindowChartTest::aKeyTheMenuAndTheToolBarOpenIt() {
    open();
    leave();
    entry().trigger();
    QVERIFY(chart() != nullptr);
    leave();
    QToolButton* button = nullptr;
    for (auto* bar : window_->findChildren<QToolBar*>()) {
        if (QWidget* widget = bar->widgetForAction(&entry())) button = qobject_cast<QToolButton*>(widget);
    }
    QVERIFY(button != nullptr && button->isVisible() && !button->icon().isNull());
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(chart() != nullptr);
    leave();
}

void WindowChartTest::theToolBarShowsTheToothOnTheBench() {
    QTRY_COMPARE_WITH_TIMEOUT(entry().iconText(), QString("Tooth 46"), kPatience);
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth[1]);
    QTRY_COMPARE_WITH_TIMEOUT(entry().iconText(), QString("Tooth 11"), kLoadPatience);
    waitForTooth();
    loadMolar();
    QTRY_COMPARE_WITH_TIMEOUT(entry().iconText(), QString("Tooth 46"), kLoadPatience);
}

void WindowChartTest::everyToothHasANameATooltipAndAPlaceOfItsOwn() {
    open();
    const auto teeth = chart()->findChildren<ToothButton*>();
    QCOMPARE(teeth.size(), 32);
    for (const ToothButton* each : teeth) {
        const QString name = QString::fromStdString(toothName(each->fdi()));
        QVERIFY2(each->accessibleName().contains(name), qPrintable(name));
        QVERIFY2(each->toolTip().contains(name), qPrintable(name));
        QCOMPARE(each->text(), QString::number(each->fdi()));
        const QPoint middle = each->mapTo(chart(), each->middle());
        QVERIFY2(chart()->childAt(middle) == each, qPrintable(name));
    }
    leave();
}

void WindowChartTest::itMarksTheLoadedToothAndThoseWithExercises() {
    open();
    QCOMPARE(focused(), 46);
    QVERIFY(tooth(46).toolTip().contains("on the bench"));
    QVERIFY(tooth(46).toolTip().contains("Pit in the molar"));
    QVERIFY(tooth(13).toolTip().contains("exercise"));
    QVERIFY(!tooth(13).toolTip().contains("on the bench"));
    QVERIFY(!tooth(27).toolTip().contains("exercise"));
    QVERIFY(chart()->findChild<QLabel*>("toothName")->text().contains("Lower right first molar"));
    const auto brightness = [this](int fdi) {  // of the tooth around its middle
        const QImage picture = tooth(fdi).grab().toImage();
        const QPoint middle = tooth(fdi).middle() * picture.devicePixelRatio();
        double sum = 0;
        for (int x = -8; x <= 8; ++x) {
            for (int y = -8; y <= 8; ++y) sum += picture.pixelColor(middle + QPoint(x, y)).lightnessF() / (17 * 17);
        }
        return sum;
    };
    QVERIFY(std::abs(brightness(46) - brightness(47)) > 0.1);
    QVERIFY(std::abs(brightness(16) - brightness(26)) < 0.02);
    leave();
}

void WindowChartTest::anotherNotationIsShownAndKept() {
    open();
    auto* notation = chart()->findChild<QComboBox*>("notation");
    QCOMPARE(notation->currentIndex(), 0);
    notation->setCurrentIndex(1);
    QCOMPARE(tooth(46).text(), QString("30"));
    QVERIFY(tooth(46).accessibleName().startsWith("30"));
    QCOMPARE(entry().iconText(), QString("Tooth 30"));
    notation->setCurrentIndex(2);
    QCOMPARE(tooth(46).text(), QStringLiteral("6┐"));
    leave();
    const WindowSettings settings = window_->settings();
    QCOMPARE(settings.notation, std::string("palmer"));
    MainWindow other(*sound_);
    other.apply(settings);
    QCOMPARE(other.settings().notation, settings.notation);
    open();
    QCOMPARE(tooth(21).text(), QStringLiteral("└1"));
    chart()->findChild<QComboBox*>("notation")->setCurrentIndex(0);
    leave();
    QCOMPARE(window_->settings().notation, std::string("fdi"));
}

void WindowChartTest::arrowsAndTypedNumbersGoToATooth() {
    open();
    QCOMPARE(focused(), 46);
    press(Qt::Key_Right);
    QCOMPARE(focused(), 45);
    press(Qt::Key_Up);
    QCOMPARE(focused(), 15);
    press(Qt::Key_End);
    QCOMPARE(focused(), 28);
    press(Qt::Key_Down);
    press(Qt::Key_Home);
    QCOMPARE(focused(), 48);
    press(Qt::Key_2);
    press(Qt::Key_4);
    QCOMPARE(focused(), 24);
    QVERIFY(chart()->findChild<QLabel*>("toothName")->text().contains("Upper left first premolar"));
    int stops = 0;
    for (const ToothButton* each : chart()->findChildren<ToothButton*>()) {
        stops += (each->focusPolicy() & Qt::TabFocus) != 0 ? 1 : 0;
    }
    QCOMPARE(stops, 1);  // the Tab key does not stop at each tooth
    leave();
}

void WindowChartTest::enterTakesTheTooth() {
    open();
    tooth(46).setFocus();
    press(Qt::Key_Left);
    press(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(chart() == nullptr, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->mouthTooth, 47, kLoadPatience);
    waitForTooth();
    QTRY_COMPARE_WITH_TIMEOUT(entry().iconText(), QString("Tooth 47"), kPatience);
}

void WindowChartTest::aClickTakesTheTooth() {
    open();
    QCOMPARE(focused(), 47);
    QTest::mouseClick(&tooth(21), Qt::LeftButton, {}, tooth(21).middle());
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->mouthTooth, 21, kLoadPatience);
    waitForTooth();
    QVERIFY(chart() == nullptr);
}

void WindowChartTest::leavingItChangesNothing() {
    const CutModel* before = window_->model().tooth()->piece.get();
    open();
    press(Qt::Key_Left);
    leave();
    waitForSteps(3);
    QVERIFY(!window_->isBusy());
    QVERIFY(window_->model().tooth()->piece.get() == before);
}

void WindowChartTest::itIsLegibleInBothColoursAndLanguages() {
    for (const bool dark : {false, true}) {
        applyColours(dark);
        open();
        const QImage picture = chart()->grab().toImage();
        const QPalette& colours = chart()->palette();
        const double contrast =
            std::abs(colours.color(QPalette::WindowText).lightnessF() - colours.color(QPalette::Base).lightnessF());
        QVERIFY(contrast > 0.5);
        QVERIFY(picture.width() > 300 && picture.height() > 450);
        leave();
    }
    applyColours(false);
    applyLanguage(*qApp, "ja");
    open();
    QVERIFY(tooth(46).accessibleName().contains(QStringLiteral("下顎右側第一大臼歯")));
    QCOMPARE(chart()->windowTitle(), QStringLiteral("歯列図"));
    leave();
    applyLanguage(*qApp, "en");
}

void WindowChartTest::savePictures(const QString& folder) {
    initTestCase();
    for (const bool dark : {false, true}) {
        applyColours(dark);
        open();
        chart()->findChild<QComboBox*>("notation")->setCurrentIndex(dark ? 2 : 0);
        (void)waitForQuietPicture();
        chart()->grab().save(folder + (dark ? "/tooth-chart-dark.png" : "/tooth-chart.png"));
        leave();
    }
    applyColours(false);
    applyLanguage(*qApp, "ja");
    open();
    chart()->grab().save(folder + "/tooth-chart-ja.png");
    leave();
    applyLanguage(*qApp, "en");
    window_->grab().save(folder + "/window-with-chart-button.png");
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_chart_tests --pictures FOLDER` saves pictures instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowChartTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--pictures") {
        test.savePictures(arguments.value(2));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_chart_test.moc"
