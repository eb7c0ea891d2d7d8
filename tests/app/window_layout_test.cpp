// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where things are in the window, what the view keys reset, and what another language leaves as it was.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QRegularExpression>
#include <QToolBar>
#include <QToolButton>

#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/event_panel.h"
#include "app/gui/scene/clear_view.h"
#include "app/gui/scene/event_banner.h"
#include "app/gui/scene/session_scene.h"
#include "app/gui/settings/window_setup.h"
#include "app/gui/window/window_owner.h"
#include "app/window_session.h"

namespace tactooth {

class WindowLayoutTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Saves pictures of the window: as it starts, in dark colours with a menu, with large text, in Japanese.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void ctrlShiftSAsksWhereToExportTheTooth();
    void anotherLanguageLeavesTheDocksWhereTheyAre();
    void anotherLanguageKeepsCutAndThePedal();
    void toolBarsShowNoKeyboardMarks();
    void keyZeroTurnsShiftsAndZoomsBack();
    void keyFLetsTheCrownFillThePicture();
    void theDriveChoosesTheHandpiece();
    void everyCommandHasAnIconInTheColourOfTheTexts();
    void aMenuHasOneContour();
    void theDemonstrationShowsWhatTheBurDoes();
    void largeTextLeavesThePictureItsPlaceAndGoesBack();
    void theWindowFitsASmallScreen();
    void whatHappensIsSaidInThePicture();
    void theStatusLineSpeaksOfTheForceNotOfTheServo();
    void resetBringsBackTheLayoutOfTheFirstStart();
    void cleanupTestCase();

private:
    /// Opens a second window with the tooth ready.
    [[nodiscard]] std::unique_ptr<WindowOwner> ownWindow();
    void chooseJapanese(WindowOwner& owner);
    /// Where each dock and each tool bar is.
    [[nodiscard]] static QStringList layoutOf(const MainWindow& window);
};

void WindowLayoutTest::initTestCase() {
    qputenv("XDG_CACHE_HOME", folder_.path().c_str());  // the cache of teeth
    openWindowWithSettings();
    waitForTooth();
}

void WindowLayoutTest::cleanupTestCase() { closeWindow(); }

/// Also where the desktop has no key of its own for "Save as".
void WindowLayoutTest::ctrlShiftSAsksWhereToExportTheTooth() {
    key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() != nullptr, kPatience);
    auto* dialog = window_->findChild<QFileDialog*>();
    QCOMPARE(dialog->acceptMode(), QFileDialog::AcceptSave);
    QVERIFY2(dialog->windowTitle().contains("Export"), qPrintable(dialog->windowTitle()));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() == nullptr, kPatience);
}

std::unique_ptr<WindowOwner> WindowLayoutTest::ownWindow() {
    auto owner = std::make_unique<WindowOwner>(*qApp, *sound_);
    MainWindow& window = owner->open(window_->settings());
    window.teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    window.show();
    (void)QTest::qWaitFor([&] { return !window.isBusy() && window.model().runner() != nullptr; }, kLoadPatience);
    return owner;
}

void WindowLayoutTest::chooseJapanese(WindowOwner& owner) {
    const QPointer before = &owner.window();
    owner.window().findChild<QMenu*>("language")->actions()[2]->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(before == nullptr && owner.window().isVisible(), kPatience);
    QCOMPARE(owner.window().menuBar()->actions().front()->text(), QStringLiteral("ファイル(&F)"));
    QTRY_VERIFY_WITH_TIMEOUT(!owner.window().isBusy() && owner.window().model().runner() != nullptr, kLoadPatience);
}

void WindowLayoutTest::anotherLanguageLeavesTheDocksWhereTheyAre() {
    const auto owner = ownWindow();
    auto* moved = owner->window().findChild<QDockWidget*>("Look inside");
    owner->window().addDockWidget(Qt::LeftDockWidgetArea, moved);
    owner->window().findChild<QDockWidget*>("History")->hide();
    const auto areas = [&] {
        std::map<QString, std::pair<Qt::DockWidgetArea, bool>> result;
        for (auto* dock : owner->window().findChildren<QDockWidget*>()) {
            result[dock->objectName()] = {owner->window().dockWidgetArea(dock), dock->isHidden()};
        }
        return result;
    };
    const auto before = areas();
    QVERIFY(before.at("Look inside").first == Qt::LeftDockWidgetArea && before.at("History").second);
    chooseJapanese(*owner);
    QVERIFY(areas() == before);
    QCOMPARE(owner->window().findChild<QDockWidget*>("Look inside")->windowTitle(), QStringLiteral("内部を見る"));
    applyLanguage(*qApp, "en");
}

void WindowLayoutTest::anotherLanguageKeepsCutAndThePedal() {
    const auto owner = ownWindow();
    const auto kept = [&] { return owner->window().findChild<QCheckBox*>("keepPedal"); };
    owner->window().findChild<DrillBar*>()->cutAction()->setChecked(true);
    kept()->setChecked(true);
    chooseJapanese(*owner);
    QVERIFY(owner->window().findChild<DrillBar*>()->isCutting());
    QVERIFY(kept()->isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(owner->window().model().log().newest().input.cutting, kPatience);
    kept()->setChecked(false);
    applyLanguage(*qApp, "en");
}

void WindowLayoutTest::toolBarsShowNoKeyboardMarks() {
    const auto owner = ownWindow();
    chooseJapanese(*owner);
    int shown = 0;
    for (const auto* bar : owner->window().findChildren<QToolBar*>()) {
        for (const auto* button : bar->findChildren<QToolButton*>()) {
            const QString text = button->text();
            QVERIFY2(!text.contains('&') && !text.contains(QRegularExpression(R"(\(\w\))")), qPrintable(text));
            if (!text.isEmpty()) ++shown;
        }
    }
    QVERIFY(shown > 10);
    applyLanguage(*qApp, "en");
}

void WindowLayoutTest::keyZeroTurnsShiftsAndZoomsBack() {
    key(Qt::Key_0);
    const auto eye = [&] { return view().camera().cameraInWorld; };
    const Pose before = eye();
    view().setView(StandardView::Lingual);
    view().zoomBy(0.3);
    view().orbitBy(Vec2(0.2, 0.1), true);
    QVERIFY((eye().position - before.position).norm() > 10);
    key(Qt::Key_0);
    QVERIFY((eye().position - before.position).norm() < 1e-9);
    QVERIFY(eye().rotation.angularDistance(before.rotation) < 1e-9);
}

/// By the projected corners of the tooth's own triangles.
void WindowLayoutTest::keyFLetsTheCrownFillThePicture() {
    const TriangleMesh& mesh = surface().base->mesh();
    const double crown = window_->model().tooth()->box().max().z() - 9;  // mm
    for (const Qt::Key side : {Qt::Key_0, Qt::Key_1, Qt::Key_2, Qt::Key_4}) {
        key(side);
        key(Qt::Key_F);
        const ImageSize size{view().width(), view().height()};
        Vec2 low(1e9, 1e9), high(-1e9, -1e9);
        for (const Vec3f& vertex : mesh.vertices) {
            if (vertex.z() < crown) continue;
            const auto pixel = project(view().camera(), size, vertex.cast<double>());
            QVERIFY(pixel.has_value());
            low = low.cwiseMin(*pixel);
            high = high.cwiseMax(*pixel);
        }
        const double filled = std::max((high.x() - low.x()) / size.width, (high.y() - low.y()) / size.height);
        QVERIFY2(filled > 0.7 && filled < 0.81, qPrintable(QString::number(filled)));
    }
    key(Qt::Key_0);
}

void WindowLayoutTest::theDriveChoosesTheHandpiece() {
    const auto shown = [&] { return sceneContents(window_->model(), true, false).tool->turbine; };
    const QString before = window_->findChild<DrillBar*>()->spindleName();
    const HandpieceMeshes& handpieces = window_->model().instruments().meshes()->handpieces;
    QCOMPARE(shown(), handpieces.turbine);
    window_->findChild<DrillBar*>()->choose({}, QString::fromStdString(spindlePresets()[2].name));
    waitForTooth();
    QTRY_COMPARE_WITH_TIMEOUT(shown(), handpieces.lowSpeed, kPatience);
    window_->findChild<DrillBar*>()->choose({}, before);
    waitForTooth();
    QTRY_COMPARE_WITH_TIMEOUT(shown(), handpieces.turbine, kPatience);
}

/// Commands are what the menus show first or what has a key; plain values in submenus, as a size, need none.
void WindowLayoutTest::everyCommandHasAnIconInTheColourOfTheTexts() {
    QVERIFY(!QApplication::windowIcon().isNull());
    int checked = 0;
    const std::function<void(const QMenu&, bool)> check = [&](const QMenu& menu, bool isFirst) {
        for (QAction* action : menu.actions()) {
            if (action->menu() != nullptr) check(*action->menu(), false);
            if (action->isSeparator() || (!isFirst && action->shortcut().isEmpty())) continue;
            QVERIFY2(!action->icon().isNull(), qPrintable(action->text()));
            if (menu.objectName() == "instruments") continue;  // pictures of surfaces, which the tray alone shows
            for (const bool dark : {false, true}) {
                applyColours(dark);
                const QColor text = QApplication::palette().color(QPalette::ButtonText);
                const QImage picture = action->icon().pixmap(48, 48).toImage();
                int drawn = 0;
                for (int y = 0; y < picture.height(); ++y) {
                    for (int x = 0; x < picture.width(); ++x) {
                        const QColor pixel = picture.pixelColor(x, y);
                        if (pixel.alpha() < 255) continue;
                        ++drawn;
                        QVERIFY2(std::abs(pixel.lightness() - text.lightness()) < 4, qPrintable(action->text()));
                    }
                }
                QVERIFY2(drawn > 40, qPrintable(action->text()));
            }
            ++checked;
        }
    };
    for (QAction* top : window_->menuBar()->actions()) check(*top->menu(), true);
    applyColours(false);
    QVERIFY2(checked > 45, qPrintable(QString::number(checked)));
}

/// From the edge inwards there is one line, and then the ground of the menu.
void WindowLayoutTest::aMenuHasOneContour() {
    for (const bool dark : {false, true}) {
        applyColours(dark);
        QMenu* menu = window_->menuBar()->actions().front()->menu();
        menu->popup(QPoint(50, 50));
        QTRY_VERIFY_WITH_TIMEOUT(menu->isVisible(), kPatience);
        const QImage picture = menu->grab().toImage();
        menu->close();
        const QRgb line = picture.pixel(0, picture.height() / 2);
        const QRgb ground = picture.pixel(3, picture.height() / 2);
        QVERIFY(line != ground);
        for (const int x : {1, 2}) QCOMPARE(picture.pixel(x, picture.height() / 2), ground);
        QCOMPARE(picture.pixel(picture.width() - 1, picture.height() / 2), line);
        for (const int x : {2, 3}) QCOMPARE(picture.pixel(picture.width() - x, picture.height() / 2), ground);
    }
    applyColours(false);
}

void WindowLayoutTest::theDemonstrationShowsWhatTheBurDoes() {
    loadMolar();
    auto* tour = window_->findChild<GuidedTour*>();
    window_->model().manipulator().rotateHandle(1.5);  // between the eye and the tip
    tour->start();
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") > 0.1, kPatience);
    Surface handpiece;
    handpiece.base = std::make_shared<const SurfacePart>(*window_->model().instruments().meshes()->handpieces.turbine);
    const Pose tool = window_->model().log().newest().contact.proxy;
    const Vec3 toEye = (view().camera().cameraInWorld.position - tool.position).normalized();
    const double seen = seenShare({surface(), &handpiece}, tool, toEye);
    QVERIFY2(seen >= 0.9, qPrintable(QString::number(seen)));
    tour->stop();
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") < 0.01, kPatience);
    key(Qt::Key_0);
}

void WindowLayoutTest::largeTextLeavesThePictureItsPlaceAndGoesBack() {
    const QList<QAction*> sizes = window_->findChild<QMenu*>("textSize")->actions();
    const QSize window = window_->size();
    const int usual = window_->fontMetrics().height();
    constexpr std::array kInFront = {"Drill", "Force", "Look inside"};  // of their tabs
    const auto widths = [&] {
        std::vector<int> result;
        for (const char* name : kInFront) result.push_back(window_->findChild<QDockWidget*>(name)->width());
        return result;
    };
    const std::vector<int> before = widths();
    sizes.back()->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(window_->fontMetrics().height() > 1.8 * usual, kPatience);
    waitForSteps(5);
    QVERIFY2(window_->width() <= window.width() && window_->height() <= window.height(), "the window has grown");
    for (const int width : widths()) {
        QVERIFY2(width < 0.36 * window.width(), qPrintable(QString::number(width)));
    }
    sizes.front()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(window_->fontMetrics().height(), usual, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(widths() == before, kPatience);
    QCOMPARE(window_->size(), window);
}

/// 1366 x 768 is the smallest screen of laptops; a task bar and the title of the window take a part of it.
void WindowLayoutTest::theWindowFitsASmallScreen() {
    const QSize size = window_->size();
    const QList<QAction*> sizes = window_->findChild<QMenu*>("textSize")->actions();
    for (QAction* text : {sizes.front(), sizes.at(1)}) {
        text->trigger();
        waitForSteps(5);
        const QSize least = window_->minimumSizeHint();
        QVERIFY2(least.width() <= 1366 && least.height() <= 768 - 70,
                 qPrintable(QString("%1: %2 x %3").arg(text->text()).arg(least.width()).arg(least.height())));
    }
    sizes.front()->trigger();
    waitForSteps(5);
    window_->resize(1366, 698);
    QTRY_COMPARE_WITH_TIMEOUT(window_->size(), QSize(1366, 698), kPatience);
    window_->resize(size);
    QTRY_COMPARE_WITH_TIMEOUT(window_->size(), size, kPatience);
}

void WindowLayoutTest::whatHappensIsSaidInThePicture() {
    const auto* banner = window_->findChild<EventBanner*>();
    auto* events = window_->findChild<EventPanel*>();
    events->show({});
    const double now = window_->model().log().newest().time;
    const CutEvent old{CutEventKind::PulpExposed, now - 60, Vec3::Zero()};
    const CutEvent first{CutEventKind::FirstContact, now, Vec3::Zero()};
    const CutEvent dentin{CutEventKind::DentinReached, now, Vec3::Zero()};
    const CutEvent near{CutEventKind::PulpNear, now, Vec3::Zero()};
    const CutEvent pulp{CutEventKind::PulpExposed, now, Vec3::Zero()};
    const CutEvent stall{CutEventKind::BurStalled, now, Vec3::Zero()};
    events->show(std::array{old, first});
    QCOMPARE(banner->text(), QString());
    events->show(std::array{old, first, dentin});
    QCOMPARE(banner->text(), QString("Dentin reached"));
    QVERIFY(banner->isVisible() && view().rect().contains(banner->geometry()));
    const QImage amber = window_->grab().toImage();
    events->show(std::array{old, first, dentin, near});
    QCOMPARE(banner->text(), QString("Pulp near"));
    events->show(std::array{old, first, dentin, near, pulp});
    QCOMPARE(banner->text(), QString("Pulp exposed"));
    events->show(std::array{old, first, dentin, near, pulp, stall});
    QCOMPARE(banner->text(), QString("Pulp exposed"));  // harm stays
    QVERIFY(window_->grab().toImage() != amber);
    // The mouse works through it.
    QCOMPARE(view().childAt(banner->geometry().center()), nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(banner->isHidden(), kPatience);
}

void WindowLayoutTest::theStatusLineSpeaksOfTheForceNotOfTheServo() {
    const auto* pace = window_->findChild<QLabel*>("pace");
    QTRY_VERIFY_WITH_TIMEOUT(pace->text().contains("Force on time") || pace->text().contains("Force late"), kPatience);
    QVERIFY(!pace->text().contains("Servo"));
    QTRY_VERIFY_WITH_TIMEOUT(pace->toolTip().contains("p99"), kPatience);
}

QStringList WindowLayoutTest::layoutOf(const MainWindow& window) {
    const auto placeOf = [](const QWidget& widget) {
        const QRect place = widget.geometry();
        return QString("%1 %2 %3 %4").arg(place.x()).arg(place.y()).arg(place.width()).arg(place.height());
    };
    QStringList lines = {QString("%1 x %2").arg(window.width()).arg(window.height())};
    for (auto* dock : window.findChildren<QDockWidget*>()) {
        QStringList tabs;
        for (const QDockWidget* other : window.tabifiedDockWidgets(dock)) tabs << other->objectName();
        const bool isInSight = dock->isVisible() && !dock->visibleRegion().isEmpty();
        lines << QString("%1: %2 %3 %4 [%5] %6")
                     .arg(dock->objectName())
                     .arg(window.dockWidgetArea(dock))
                     .arg(dock->isFloating())
                     .arg(dock->isHidden())
                     .arg(tabs.join(','), isInSight ? placeOf(*dock) : QString());
    }
    for (auto* bar : window.findChildren<QToolBar*>()) {
        lines << QString("%1: %2 %3 %4")
                     .arg(bar->objectName())
                     .arg(window.toolBarArea(bar))
                     .arg(bar->isHidden())
                     .arg(placeOf(*bar));
    }
    lines.sort();  // a dock that has floated is another child
    return lines;
}

void WindowLayoutTest::resetBringsBackTheLayoutOfTheFirstStart() {
    WindowOwner owner(*qApp, *sound_);
    MainWindow& window = owner.open(WindowSettings());
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window, kPatience));
    QStringList first;
    int unchanged = 0;  // looks, 50 ms apart
    const auto isSettled = [&] {
        const QStringList before = std::exchange(first, layoutOf(window));
        unchanged = before == first ? unchanged + 1 : 0;
        return unchanged >= 10;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), kPatience);
    window.addDockWidget(Qt::LeftDockWidgetArea, window.findChild<QDockWidget*>("Look inside"));
    window.findChild<QDockWidget*>("History")->hide();
    window.findChild<QDockWidget*>("Exercise")->setFloating(true);
    window.findChild<QDockWidget*>("Sound")->raise();
    window.addToolBar(Qt::LeftToolBarArea, window.findChild<QToolBar*>("viewBar"));
    window.findChild<QToolBar*>("drillBar")->hide();
    window.resize(1250, 850);
    QTRY_VERIFY_WITH_TIMEOUT(window.width() == 1250 && layoutOf(window) != first, kPatience);
    window.findChild<QAction*>("resetLayout")->trigger();
    QStringList now;
    const bool isBack = QTest::qWaitFor([&] { return (now = layoutOf(window)) == first; }, kPatience);
    for (qsizetype i = 0; i < first.size() && !isBack; ++i) QCOMPARE(now.value(i), first[i]);
    QVERIFY(isBack);
}

void WindowLayoutTest::savePictures(const QString& folder) {
    initTestCase();
    const auto save = [&](QWidget& widget, const char* name) {
        (void)waitForQuietPicture();
        widget.grab().save(folder + '/' + name + ".png");
    };
    save(*window_, "start");
    key(Qt::Key_F);
    window_->findChild<EventBanner*>()->announce(CutEventKind::PulpExposed);
    window_->grab().save(folder + "/fit-banner.png");
    key(Qt::Key_0);
    for (QAction* top : window_->menuBar()->actions()) {
        top->menu()->popup(QPoint(50, 50));
        top->menu()->grab().save(folder + "/menu-" + top->text().remove('&') + ".png");
        applyColours(true);
        top->menu()->grab().save(folder + "/menu-" + top->text().remove('&') + "-dark.png");
        applyColours(false);
        top->menu()->close();
    }
    const auto section = window_->findChild<QComboBox*>("section");
    for (const int side : {1, 4, 5}) {
        section->setCurrentIndex(side);
        save(*window_, qPrintable(QString("section-%1").arg(section->currentText())));
    }
    section->setCurrentIndex(0);
    key(Qt::Key_D, Qt::ControlModifier);
    save(*window_, "dark");
    key(Qt::Key_D, Qt::ControlModifier);
    window_->findChild<QMenu*>("textSize")->actions().back()->trigger();
    save(*window_, "large");
    window_->findChild<QMenu*>("textSize")->actions().front()->trigger();
    save(*window_, "usual-again");
    window_->resize(1366, 698);
    save(*window_, "small-screen");
    window_->findChild<GuidedTour*>()->start();
    (void)QTest::qWaitFor([&] { return gauge("forceGauge") > 0.1; }, kPatience);
    window_->grab().save(folder + "/demonstration.png");
    window_->findChild<GuidedTour*>()->stop();
    window_->findChild<DrillBar*>()->choose({}, QString::fromStdString(spindlePresets()[2].name));
    waitForTooth();
    save(*window_, "low-speed");
    {
        const auto owner = ownWindow();
        chooseJapanese(*owner);
        save(owner->window(), "japanese");
    }
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_layout_tests --pictures FOLDER` saves pictures of the window instead of testing it.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowLayoutTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--pictures") {
        test.savePictures(arguments.value(2));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_layout_test.moc"
