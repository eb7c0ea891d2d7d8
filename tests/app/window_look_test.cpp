// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window beside the drilling: looking inside, plots, files, colours, languages.
#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QSet>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>
#include <QTranslator>
#include <fstream>

#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/panels/elided_label.h"
#include "app/gui/panels/timing_panel.h"
#include "app/gui/settings/window_setup.h"
#include "app/gui/window/window_owner.h"
#include "app/window_session.h"
#include "geometry/io/stl_writer.h"
#include "session/model/slow_device.h"
#include "sound/sound_files.h"
#include "support/shapes.h"

namespace tactooth {

class WindowLookTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void synthesisedSoundsWinOverARecordingThatIsStillRead();
    void aHintThatDoesNotFitEndsInDots();
    void theInsideOfTheToothIsShown();
    void aSectionGoesWithTheBur();
    void aSecondViewShowsAnotherSideAndAClickGoesThere();
    void aTargetColoursTheTooth();
    void theGhostOfATargetIsSwitchedByClickAndKey();
    void aTargetWithoutACavityHasNoGhost();
    void thePlotsHoldStillZoomAndAreExported();
    void theRealTimePanelShowsTheTicksAndCountsAnew();
    void theRealTimePanelShowsHowLongPicturesTake();
    void aHeavySceneIsSaidWithoutTakingTheKeys();
    void openedTeethAreInTheRecentMenu();
    void darkColoursAndBack();
    void anotherLanguageComesAtOnceWithTheToothAsItIs();
    void aJapaneseWindowSpeaksJapanese();
    void theDemonstrationTouchesAndEndsWithAClick();
    void cleanupTestCase();

private:
    [[nodiscard]] QAction* action(const QString& text) const;
};

void WindowLookTest::initTestCase() {
    openWindowWithSettings();
    waitForTooth();
}

void WindowLookTest::cleanupTestCase() { closeWindow(); }

void WindowLookTest::aHintThatDoesNotFitEndsInDots() {
    const auto* hint = window_->findChild<ElidedLabel*>("hint");
    const QSize size = window_->size();
    window_->resize(2400, size.height());
    QTRY_COMPARE_WITH_TIMEOUT(hint->shown(), hint->text(), kPatience);
    QVERIFY(!hint->text().isEmpty());
    for (int width = 2400; width > 600 && hint->shown() == hint->text(); width -= 50) {
        window_->resize(width, size.height());
        (void)QTest::qWaitFor([&] { return window_->width() == width; }, 5000);
        QCoreApplication::processEvents();
    }
    QVERIFY2(hint->shown().endsWith(QChar(0x2026)), qPrintable(hint->shown()));
    window_->resize(size);
}

void WindowLookTest::synthesisedSoundsWinOverARecordingThatIsStillRead() {
    test::writeTone(folder_ / "late.wav", 48000 * 5, 0.3);
    auto* sounds = window_->findChild<QComboBox*>("sounds");
    window_->sounds().open(QString::fromStdString(folder_ / "late.wav"));
    emit sounds->activated(0);  // before the window has polled the result
    QTRY_VERIFY_WITH_TIMEOUT(!window_->sounds().isReading(), kPatience);
    QCOMPARE(sounds->currentText(), QString("Synthesised"));
    QVERIFY(window_->settings().ownSounds.empty());
}

void WindowLookTest::theInsideOfTheToothIsShown() {
    loadMolar();
    const QImage whole = view().grabFramebuffer();
    auto* section = window_->findChild<QComboBox*>("section");
    section->setFocus();
    QTest::keyClick(section, Qt::Key_Down);
    QTest::keyClick(section, Qt::Key_Down);
    QCOMPARE(section->currentText(), QString("Buccal"));
    const QImage opened = view().grabFramebuffer();
    QVERIFY(opened != whole);
    window_->findChild<QSlider*>("sectionPlace")->setValue(20);
    QVERIFY(view().grabFramebuffer() != opened);
    section->setCurrentIndex(0);
    auto* enamel = window_->findChild<QSlider*>("enamelOpacity");
    enamel->setValue(30);
    QVERIFY(view().grabFramebuffer() != whole);
    enamel->setValue(100);
    auto* eyes = window_->findChild<QComboBox*>("stereo");
    eyes->setCurrentIndex(1);
    QVERIFY(view().grabFramebuffer() != whole);
    eyes->setCurrentIndex(0);
}

void WindowLookTest::aSectionGoesWithTheBur() {
    loadMolar();
    auto* section = window_->findChild<QComboBox*>("section");
    auto* follows = window_->findChild<QCheckBox*>("sectionFollows");
    auto* place = window_->findChild<QSlider*>("sectionPlace");
    QVERIFY(!follows->isEnabled());
    section->setCurrentText("Mesial");
    QVERIFY(place->isEnabled());
    follows->setChecked(true);
    QVERIFY(!place->isEnabled());
    const auto atTip = [&] {
        const double tip = window_->model().log().newest().contact.proxy.position.x();
        const double middle = window_->model().tooth()->box().center().x();
        return std::abs(place->value() / 10.0 - window_->model().mesialX() * (tip - middle)) <= 0.051;
    };
    QSet<int> places;
    for (const int aside : {-60, 60}) {
        QTest::mouseMove(&view(), view().rect().center() + QPoint(aside, 0));
        QTRY_VERIFY_WITH_TIMEOUT(atTip() && !places.contains(place->value()), kPatience);
        places.insert(place->value());
    }
    follows->setChecked(false);
    QVERIFY(place->isEnabled());
    section->setCurrentIndex(0);
}

void WindowLookTest::aSecondViewShowsAnotherSideAndAClickGoesThere() {
    loadMolar();
    view().setFocus();
    auto* frame = window_->findChild<QAbstractButton*>("secondViewFrame");
    QVERIFY(!frame->isVisible());
    QVERIFY(waitForQuietPicture());  // a slow machine draws coarsely before
    const QImage alone = view().grabFramebuffer();
    key(Qt::Key_3, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(frame->isVisible(), kPatience);
    QVERIFY(waitForQuietPicture());
    QCOMPARE(frame->text(), QString("Lingual"));
    const double ratio = view().devicePixelRatioF();
    const QRect corner(frame->pos() * ratio, frame->size() * ratio);
    const QImage both = view().grabFramebuffer();
    QVERIFY(both.copy(corner) != alone.copy(corner));
    const QRect rest(0, corner.bottom() + 2, both.width(), both.height() - corner.bottom() - 2);
    QVERIFY(both.copy(rest) == alone.copy(rest));

    auto* eyes = window_->findChild<QComboBox*>("stereo");
    eyes->setCurrentIndex(1);
    QVERIFY2(!frame->isVisible(), "stereo leaves no space for it");
    eyes->setCurrentIndex(0);
    QVERIFY(frame->isVisible());

    QTest::mouseClick(frame, Qt::LeftButton);
    QVERIFY(view().camera().cameraInWorld.position.y() < -10);  // buccal is +y
    QVERIFY(!window_->model().manipulator().isPressing());
    key(Qt::Key_0, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!frame->isVisible(), kPatience);
    key(Qt::Key_0);
}

void WindowLookTest::aTargetColoursTheTooth() {
    const auto file = folder_ / "target.stl";
    QVERIFY(writeStl(test::sphere(Vec3(0, 0, 3), 4, 40, 30), file).has_value());
    auto* coloured = window_->findChild<QCheckBox*>("coloured");
    QVERIFY(!coloured->isEnabled());
    const QImage before = view().grabFramebuffer();
    window_->exercise().openTarget(QString::fromStdString(file.string()));
    QTRY_VERIFY_WITH_TIMEOUT(coloured->isChecked(), kLoadPatience);
    QVERIFY(view().grabFramebuffer() != before);
    QTest::mouseClick(coloured, Qt::LeftButton, {}, QPoint(8, coloured->height() / 2));
    QVERIFY(!coloured->isChecked());
}

void WindowLookTest::theGhostOfATargetIsSwitchedByClickAndKey() {
    loadMolar();
    auto* ghost = window_->findChild<QCheckBox*>("ghost");
    auto* coloured = window_->findChild<QCheckBox*>("coloured");
    auto* entry = window_->findChild<QAction*>("showGhost");
    QVERIFY(!ghost->isEnabled() && !entry->isEnabled());
    QVERIFY(ghost->toolTip().contains("Choose a target first"));
    const QImage plain = view().grabFramebuffer();
    // A ball of 2 mm in the fossa, some millimetres below the cusps.
    const Box3 box = window_->model().tooth()->box();
    const auto file = folder_ / "cavity.stl";
    QVERIFY(writeStl(test::sphere(Vec3(0, 0, box.max().z() - 3), 2, 40, 30), file).has_value());
    window_->exercise().openTarget(QString::fromStdString(file.string()));
    QTRY_VERIFY_WITH_TIMEOUT(coloured->isChecked(), kLoadPatience);
    QVERIFY(ghost->isEnabled() && entry->isEnabled() && !ghost->isChecked());
    const QImage colours = view().grabFramebuffer();
    QTest::mouseClick(ghost, Qt::LeftButton, {}, QPoint(8, ghost->height() / 2));
    QVERIFY(ghost->isChecked() && entry->isChecked() && !coloured->isChecked());
    const QImage glass = view().grabFramebuffer();
    QVERIFY(glass != plain && glass != colours);
    key(Qt::Key_G);
    QVERIFY(!ghost->isChecked() && !coloured->isChecked());
    QVERIFY(view().grabFramebuffer() != glass);
    key(Qt::Key_G);
    QVERIFY(ghost->isChecked());
    QTest::mouseClick(coloured, Qt::LeftButton, {}, QPoint(8, coloured->height() / 2));
    QVERIFY(!ghost->isChecked() && coloured->isChecked());
    loadMolar();  // the target does not fit another tooth
    QVERIFY(!ghost->isEnabled() && !entry->isEnabled() && !ghost->isChecked());
}

void WindowLookTest::aTargetWithoutACavityHasNoGhost() {
    const auto file = folder_ / "around.stl";
    QVERIFY(writeStl(test::sphere(Vec3::Zero(), 40, 40, 30), file).has_value());
    window_->exercise().openTarget(QString::fromStdString(file.string()));
    auto* coloured = window_->findChild<QCheckBox*>("coloured");
    QTRY_VERIFY_WITH_TIMEOUT(coloured->isChecked(), kLoadPatience);
    auto* ghost = window_->findChild<QCheckBox*>("ghost");
    QVERIFY(!ghost->isEnabled());
    QVERIFY2(ghost->toolTip().contains("no cavity"), qPrintable(ghost->toolTip()));
    coloured->setChecked(false);
}

void WindowLookTest::thePlotsHoldStillZoomAndAreExported() {
    auto* pause = window_->findChild<QToolButton*>("pausePlots");
    auto* stretch = window_->findChild<QSpinBox*>("plotStretch");
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().time > 1, kPatience);  // there is something to show
    QTest::mouseClick(pause, Qt::LeftButton);
    QVERIFY(pause->isChecked());
    stretch->setValue(4);
    for (const char* name : {"plots.csv", "plots.png", "plots.svg"}) {
        window_->records().exportPlotsTo(QString::fromStdString((folder_ / name).string()));
        waitForFiles();
        QVERIFY2(std::filesystem::file_size(folder_ / name) > 100, name);
    }
    std::ifstream table(folder_ / "plots.csv");
    std::string head;
    std::getline(table, head);
    QCOMPARE(head, std::string("t,depth,speed,force,cavity_depth"));
    window_->records().exportPlotsTo(QString::fromStdString((folder_ / "plots.doc").string()));
    waitForFiles();
    QVERIFY(dismissMessage().contains("end its name in .csv, .svg or .png"));
    QTest::mouseClick(pause, Qt::LeftButton);
    stretch->setValue(10);
}

QAction* WindowLookTest::action(const QString& text) const {
    for (QAction* each : window_->findChildren<QAction*>()) {
        if (each->text() == text) return each;
    }
    return nullptr;
}

void WindowLookTest::aHeavySceneIsSaidWithoutTakingTheKeys() {
    window_->model().install(DeviceSlot::First, std::make_unique<test::SlowDevice>());
    const auto* hint = window_->findChild<ElidedLabel*>("hint");
    QTRY_VERIFY_WITH_TIMEOUT(hint->text().contains("heavy for this machine"), kPatience);
    QCOMPARE(QApplication::activeModalWidget(), nullptr);
    window_->model().install(DeviceSlot::First, nullptr);
}

void WindowLookTest::theRealTimePanelShowsTheTicksAndCountsAnew() {
    auto* dock = window_->findChild<QDockWidget*>("Real time");
    dock->raise();
    const auto* facts = window_->findChild<QLabel*>("timingFacts");
    const auto ticks = [facts] {
        return QLocale().toULongLong(facts->text().section(' ', 0, 0));  // "12,345 ticks, ..."
    };
    QTRY_VERIFY_WITH_TIMEOUT(ticks() > 3000, kPatience);
    QVERIFY(facts->text().contains("Device: mouse"));
    const auto all = ticks();
    const auto ofRunner = [this] { return window_->model().runner()->feed().timing().ticks.load(); };
    QVERIFY(all <= ofRunner());
    QTest::mouseClick(window_->findChild<QToolButton*>("countAnew"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(ticks() > 0 && ticks() + all <= ofRunner(), kPatience);
    auto* panel = window_->findChild<TimingPanel*>();
    panel->reset();  // as at a restart of the runner
    panel->show(*window_->model().runner(), view().pictureTimes().counts(), "mouse", 1000);
    QVERIFY(ticks() >= all);
    window_->findChild<QDockWidget*>("Last ten seconds")->raise();
}

void WindowLookTest::theRealTimePanelShowsHowLongPicturesTake() {
    window_->findChild<QDockWidget*>("Real time")->raise();
    const QString row = "picture in motion, ms";
    const auto shown = [this, &row](const QString& column) {
        for (const QLabel* cell : window_->findChildren<QLabel*>()) {
            if (cell->accessibleName() == row + " " + column) return cell->text().toDouble();
        }
        return -1.0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(shown("max") >= 0, kPatience);
    QTest::mouseClick(window_->findChild<QToolButton*>("countAnew"), Qt::LeftButton);
    key(Qt::Key_2);  // another side
    QTRY_VERIFY_WITH_TIMEOUT(shown("max") > 0, kPatience);
    const double longest = view().pictureTimes().largest() / 1000;
    QVERIFY(shown("p50") <= shown("max"));
    QVERIFY2(shown("max") <= 1.03 * longest + 1, qPrintable(QString::number(longest)));  // a bucket is 3 % wide
    window_->findChild<QDockWidget*>("Last ten seconds")->raise();
}

void WindowLookTest::openedTeethAreInTheRecentMenu() {
    const auto file = folder_ / "ball.stl";
    QVERIFY(writeStl(test::sphere(Vec3(20, 0, 0), 5, 40, 30), file).has_value());
    window_->teeth().openTooth({.outer = file, .layers = {}});
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->name, std::string("ball.stl"), kLoadPatience);
    loadMolar();
    auto* recent = window_->findChild<QMenu*>("recent");
    emit recent->aboutToShow();
    QVERIFY(!recent->actions().isEmpty());
    QAction* ball = nullptr;
    for (QAction* each : recent->actions()) ball = each->text() == "ball.stl" ? each : ball;
    QVERIFY(ball != nullptr);
    ball->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->name, std::string("ball.stl"), kLoadPatience);
    waitForTooth();
    QVERIFY(window_->settings().recent.find("ball.stl") != std::string::npos);
}

void WindowLookTest::darkColoursAndBack() {
    const auto lightness = [&] { return window_->palette().color(QPalette::Window).lightness(); };
    QVERIFY(lightness() > 200);
    key(Qt::Key_D, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(lightness() < 80, kPatience);
    QVERIFY(window_->settings().dark);
    key(Qt::Key_D, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(lightness() > 200, kPatience);
}

void WindowLookTest::anotherLanguageComesAtOnceWithTheToothAsItIs() {
    WindowOwner holder(*qApp, *sound_);
    WindowSettings settings = window_->settings();
    settings.bur = "245";
    MainWindow* window = &holder.open(settings);
    window->teeth().loadBuiltinTooth(kBuiltinTeeth[1]);
    window->show();
    QTRY_VERIFY_WITH_TIMEOUT(!window->isBusy() && window->model().runner() != nullptr, kLoadPatience);
    const CutModel* piece = window->model().tooth()->piece.get();
    const auto languages = [&] { return holder.window().findChild<QMenu*>("language")->actions(); };
    const auto title = [&] { return holder.window().menuBar()->actions().front()->text(); };
    QCOMPARE(languages().size(), 3);
    QCOMPARE(title(), "&File");
    languages()[2]->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(title(), QStringLiteral("ファイル(&F)"), kPatience);
    QVERIFY(holder.window().isVisible());
    QCOMPARE(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("キャンセル"));  // Qt's own texts
    QVERIFY(languages()[2]->isChecked());
    QCOMPARE(holder.window().settings().language, std::string("ja"));
    QTRY_VERIFY_WITH_TIMEOUT(holder.window().model().runner() != nullptr, kLoadPatience);
    QCOMPARE(holder.window().model().tooth()->piece.get(), piece);  // with all of its cuts
    QTRY_VERIFY_WITH_TIMEOUT(holder.window().windowTitle().startsWith(QStringLiteral("上顎中切歯")), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!holder.window().isBusy(), kPatience);
    QCOMPARE(holder.window().settings().bur, std::string("245"));
    languages()[1]->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(title(), "&File", kPatience);
    QCOMPARE(holder.window().model().tooth()->piece.get(), piece);
    languages()[0]->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(holder.window().settings().language, std::string(), kPatience);
}

void WindowLookTest::aJapaneseWindowSpeaksJapanese() {
    QTranslator japanese;
    QVERIFY(japanese.load(":/translations/tactooth_ja.qm"));
    QApplication::installTranslator(&japanese);
    {
        MainWindow other(*sound_);
        QCOMPARE(other.menuBar()->actions().front()->text(), QStringLiteral("ファイル(&F)"));
        QCOMPARE(other.findChild<QComboBox*>("section")->itemText(2), QStringLiteral("頬側"));
        const auto* burs = other.findChild<QComboBox*>("burs");
        QCOMPARE(burs->itemText(burs->findData("4")), QStringLiteral("ラウンドカーバイド No. 4、1.4 mm"));
        for (int i = 0; i < burs->count(); ++i) {
            QVERIFY2(burs->itemText(i).contains(QStringLiteral("、")), qPrintable(burs->itemText(i)));
        }
    }
    QApplication::removeTranslator(&japanese);
}

void WindowLookTest::theDemonstrationTouchesAndEndsWithAClick() {
    loadMolar();
    action("Watch the &demonstration")->trigger();
    auto* tour = window_->findChild<GuidedTour*>();
    QVERIFY(tour->isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") > 0.1, kPatience);
    QTest::mouseClick(&view(), Qt::RightButton, {}, middle());
    QVERIFY(!tour->isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") < 0.01, kPatience);
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowLookTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_look_test.moc"
