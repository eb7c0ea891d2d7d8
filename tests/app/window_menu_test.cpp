// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every entry of every menu by real clicks, and the whole window by keys alone.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QRegularExpression>
#include <QScrollArea>
#include <set>

#include "app/gui/dialogs/text_dialog.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "support/materials.h"

namespace tactooth {

class WindowMenuTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void everyEntryOfEveryMenuCanBeClickedAndEveryDialogBeLeft();
    void noKeyIsTakenTwice();
    void aboutShowsTheVersion();
    void theShortcutSheetNamesEveryKeyOfTheMenus();
    void everyControlIsReachedByTab();
    void theBurIsMovedAndPressedByKeys();
    void keysThatAreHeldAreLetGoWhenAnotherWindowComesInFront();
    void aToothIsCutAndLookedAtByKeysAlone();
    void waterAndSuctionAreSwitchedByKeys();
    void theMirrorTakesItsSizeFogAndDrops();
    void aTissueFillsInTheForceParameters();
    void largeTextFitsIntoTheWindow();
    void everySettingIsThereAfterARestart();
    void cleanupTestCase();

private:
    void leaveDialogs(const QString& after) const;
    static bool comesUp(const QMenu& menu, const std::function<void()>& open);
    void clickThrough(QMenu& menu, const std::function<void()>& open, const QString& path);
    [[nodiscard]] std::vector<QAction*> leaves() const;
    void openSheet() const;
    [[nodiscard]] QAction* action(const char* name) const { return window_->findChild<QAction*>(name); }
    std::set<QString> clicked_;
};

void WindowMenuTest::initTestCase() {
    openWindowWithSettings();
    waitForTooth();
}

void WindowMenuTest::cleanupTestCase() { closeWindow(); }

/// Escape closes each dialog that an entry opens.
void WindowMenuTest::leaveDialogs(const QString& after) const {
    for (int i = 0; i < 6; ++i) {
        QCoreApplication::processEvents();
        QDialog* front = nullptr;
        for (QWidget* each : QApplication::topLevelWidgets()) {  // the manual has no parent
            auto* dialog = qobject_cast<QDialog*>(each);
            if (dialog != nullptr && dialog->isVisible()) front = dialog;
        }
        if (front == nullptr) return;
        QTest::keyClick(front, Qt::Key_Escape);
        (void)QTest::qWaitFor([dialog = QPointer(front)] { return dialog == nullptr || !dialog->isVisible(); }, 10'000);
    }
    QFAIL(qPrintable("a dialog stays open after " + after));
}

/// A late event of the dialog before can close a menu that opens meanwhile: a user clicks again.
bool WindowMenuTest::comesUp(const QMenu& menu, const std::function<void()>& open) {
    for (int i = 0; i < kPatience / 2000 && !menu.isVisible(); ++i) {
        open();
        (void)QTest::qWaitFor([&menu] { return menu.isVisible(); }, 2000);
    }
    return menu.isVisible();
}

void WindowMenuTest::clickThrough(QMenu& menu, const std::function<void()>& open, const QString& path) {
    QVERIFY2(comesUp(menu, open), qPrintable(path));
    const QList<QAction*> entries = menu.actions();
    for (QAction* entry : entries) {
        if (entry->isSeparator() || !entry->isEnabled()) continue;
        const QString here = path + " > " + entry->text();
        if (here.contains("Quit")) continue;  // it would end the test
        const auto clickEntry = [&menu, entry] {
            QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(entry).center());
        };
        QVERIFY2(comesUp(menu, open), qPrintable(here));
        if (entry->menu() != nullptr) {
            clickThrough(
                *entry->menu(),
                [&] {
                    if (!menu.isVisible()) open();
                    clickEntry();
                },
                here);
            continue;
        }
        int triggered = 0;
        const auto counting = connect(entry, &QAction::triggered, this, [&] { ++triggered; });
        clickEntry();
        QTRY_VERIFY2_WITH_TIMEOUT(triggered == 1, qPrintable(here), kPatience);
        disconnect(counting);
        leaveDialogs(here);
        clicked_.insert(here);
        waitForTooth();
    }
    while (QApplication::activePopupWidget() != nullptr) QApplication::activePopupWidget()->close();
}

void WindowMenuTest::everyEntryOfEveryMenuCanBeClickedAndEveryDialogBeLeft() {
    const WindowSettings before = window_->settings();
    QMenuBar& bar = *window_->menuBar();
    for (QAction* top : bar.actions()) {
        const auto open = [&] { QTest::mouseClick(&bar, Qt::LeftButton, {}, bar.actionGeometry(top).center()); };
        clickThrough(*top->menu(), open, top->text());
    }
    QVERIFY2(clicked_.size() > 40, qPrintable(QString::number(clicked_.size())));
    window_->apply(before);
    loadMolar();
}

std::vector<QAction*> WindowMenuTest::leaves() const {
    std::vector<QAction*> result;
    const std::function<void(const QMenu&)> collect = [&](const QMenu& menu) {
        for (QAction* entry : menu.actions()) {
            if (entry->menu() != nullptr) collect(*entry->menu());
            if (entry->menu() == nullptr && !entry->isSeparator()) result.push_back(entry);
        }
    };
    for (QAction* top : window_->menuBar()->actions()) collect(*top->menu());
    return result;
}

void WindowMenuTest::noKeyIsTakenTwice() {
    std::set<QString> taken;
    for (QAction* entry : leaves()) {
        const QString keys = entry->shortcut().toString();
        if (!keys.isEmpty()) QVERIFY2(taken.insert(keys).second, qPrintable(keys + ": " + entry->text()));
    }
    QVERIFY(taken.size() > 20);
}

void WindowMenuTest::aboutShowsTheVersion() {
    for (QAction* entry : leaves()) {
        if (entry->text() == "&About Tactooth") entry->trigger();
    }
    const auto* box = window_->findChild<QMessageBox*>();
    QVERIFY(box != nullptr && box->isVisible());
    static const QRegularExpression version(R"(Tactooth \d+\.\d+\.\d+</b> \([\w-]+\))");
    QVERIFY2(version.match(box->text()).hasMatch(), qPrintable(box->text()));
    leaveDialogs("About");
}

void WindowMenuTest::openSheet() const {
    for (QAction* entry : leaves()) {
        if (entry->text() == "&Mouse and keys") entry->trigger();
    }
}

void WindowMenuTest::theShortcutSheetNamesEveryKeyOfTheMenus() {
    openSheet();
    auto* dialog = window_->findChild<TextDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    const QString sheet = dialog->text();
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<TextDialog*>() == nullptr, kPatience);
    for (QAction* entry : leaves()) {
        const QString keys = entry->shortcut().toString();
        if (!keys.isEmpty()) QVERIFY2(sheet.contains(keys), qPrintable(keys + ": " + entry->text()));
    }
}

void WindowMenuTest::everyControlIsReachedByTab() {
    QApplication::setActiveWindow(window_.get());
    view().setFocus();
    std::set<QWidget*> reached;
    for (int i = 0; i < 300; ++i) {
        QWidget* now = QApplication::focusWidget();
        QVERIFY(now != nullptr);
        reached.insert(now);
        QTest::keyClick(now, Qt::Key_Tab);
    }
    for (QWidget* widget : window_->findChildren<QWidget*>()) {
        const bool isControl =
            qobject_cast<QAbstractSlider*>(widget) != nullptr || qobject_cast<QAbstractButton*>(widget) != nullptr ||
            qobject_cast<QComboBox*>(widget) != nullptr || qobject_cast<QAbstractSpinBox*>(widget) != nullptr;
        if (!isControl || !widget->isVisible() || !widget->isEnabled() || widget->window() != window_.get()) continue;
        if ((widget->focusPolicy() & Qt::TabFocus) == 0) continue;  // part of another control, or a tool button
        QVERIFY2(reached.contains(widget), qPrintable(widget->objectName() + " " + widget->metaObject()->className()));
    }
}

void WindowMenuTest::theBurIsMovedAndPressedByKeys() {
    view().setFocus();
    const Vec3 before = window_->model().manipulator().pose().position;
    for (int i = 0; i < 6; ++i) QTest::keyClick(&view(), Qt::Key_Left);
    QTRY_VERIFY_WITH_TIMEOUT((window_->model().manipulator().pose().position - before).norm() > 0.05, kPatience);
    QTest::keyPress(&view(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") > 0.1, kPatience);
    QTest::keyRelease(&view(), Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(gauge("forceGauge"), 0.0, kPatience);
}

/// The window in front receives the release of a key: the bur must neither turn nor press on.
void WindowMenuTest::keysThatAreHeldAreLetGoWhenAnotherWindowComesInFront() {
    view().setFocus();
    QTest::keyPress(&view(), Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().controls.pedal, 1.0, kPatience);
    QTest::keyPress(&view(), Qt::Key_Return);
    QVERIFY(window_->model().manipulator().isPressing());
    QEvent deactivated(QEvent::WindowDeactivate);
    QApplication::sendEvent(window_.get(), &deactivated);
    QFocusEvent unfocused(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
    QApplication::sendEvent(&view(), &unfocused);
    QVERIFY(!window_->model().manipulator().isPressing());
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().controls.pedal, 0.0, kPatience);
    pressBurOn(middle());
    QApplication::sendEvent(&view(), &unfocused);
    QVERIFY(window_->model().manipulator().isPressing());  // the mouse button is still down, and its release comes here
    liftBur(middle());
}

void WindowMenuTest::aToothIsCutAndLookedAtByKeysAlone() {
    key(Qt::Key_0);
    view().setFocus();
    const QImage before = view().grabFramebuffer();
    QTest::keyClick(&view(), Qt::Key_Left, Qt::ControlModifier);
    const QImage turned = view().grabFramebuffer();
    QVERIFY(turned != before);
    QTest::keyClick(&view(), Qt::Key_Plus);
    QVERIFY(view().grabFramebuffer() != turned);
    key(Qt::Key_0);
    key(Qt::Key_F);
    key(Qt::Key_C);
    QTest::keyPress(&view(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") > 300, kPatience);
    QTest::keyPress(&view(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(removed() > 0.01, kPatience);
    QTest::keyRelease(&view(), Qt::Key_Return);
    QTest::keyRelease(&view(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") < 1, kPatience);  // until then the bur may still cut
    const double cut = removed();
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(removed() < cut, kPatience);
    key(Qt::Key_R, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), 0.0, kPatience);
    key(Qt::Key_T);
}

void WindowMenuTest::waterAndSuctionAreSwitchedByKeys() {
    const auto flying = [&] { return window_->model().animation().particles().size(); };
    key(Qt::Key_C);
    QTest::keyPress(&view(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(flying() > 30, kPatience);
    key(Qt::Key_W);
    QVERIFY(!action("water")->isChecked());
    QTRY_COMPARE_WITH_TIMEOUT(flying(), std::size_t{0}, kPatience);
    key(Qt::Key_W);
    QTRY_VERIFY_WITH_TIMEOUT(flying() > 30, kPatience);
    QTest::keyRelease(&view(), Qt::Key_Space);
    key(Qt::Key_T);
    const QImage without = view().grabFramebuffer();
    key(Qt::Key_S);
    QVERIFY(action("suction")->isChecked());
    QVERIFY(view().grabFramebuffer() != without);
    key(Qt::Key_S);
}

void WindowMenuTest::theMirrorTakesItsSizeFogAndDrops() {
    QImage last = view().grabFramebuffer();
    const auto looksNew = [&] {
        const QImage now = view().grabFramebuffer();
        return std::exchange(last, now) != now;
    };
    const QList<QAction*> sizes = window_->findChild<QMenu*>("mirrorGlass")->actions();
    sizes[2]->trigger();
    QVERIFY(looksNew());
    QCOMPARE(window_->settings().mirror.number, std::string("5"));
    key(Qt::Key_B);
    QVERIFY(looksNew());
    key(Qt::Key_D);
    QVERIFY(looksNew());
    QVERIFY(window_->settings().mirror == (MirrorSettings{"5", true, true}));
    key(Qt::Key_B);
    key(Qt::Key_D);
    sizes[1]->trigger();
    QVERIFY(window_->settings().mirror == MirrorSettings());
}

void WindowMenuTest::aTissueFillsInTheForceParameters() {
    auto* presets = window_->findChild<QComboBox*>("forcePresets");
    presets->setFocus();
    const int caries = presets->findText("Caries");
    QVERIFY(caries > 0);
    presets->setCurrentIndex(caries);
    emit presets->activated(caries);
    const Material numbers = MaterialTable()[test::kCaries];
    QVERIFY(!window_->findChild<QCheckBox*>("fromMaterial")->isChecked());
    QCOMPARE(window_->findChild<QDoubleSpinBox*>("spring")->value(), numbers.stiffness);
    QCOMPARE(window_->findChild<QDoubleSpinBox*>("friction")->value(), numbers.friction);
    QCOMPARE(window_->model().controls.force.friction.value_or(-1), numbers.friction);
    QCOMPARE(window_->model().controls.force.stiffness.value_or(-1), numbers.stiffness);
    window_->findChild<QCheckBox*>("fromMaterial")->setChecked(true);
    QVERIFY(!window_->model().controls.force.friction.has_value());
}

void WindowMenuTest::largeTextFitsIntoTheWindow() {
    const int usual = window_->fontMetrics().height();
    const QSize size = window_->size();
    window_->findChild<QMenu*>("textSize")->actions().back()->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(window_->fontMetrics().height() > 1.8 * usual, kPatience);
    waitForSteps(5);
    QVERIFY2(window_->width() <= 1400 && window_->height() <= 900,
             qPrintable(QString("%1 x %2").arg(window_->width()).arg(window_->height())));
    const QRect whole(QPoint(0, 0), window_->size());
    for (auto* area : window_->findChildren<QScrollArea*>()) {
        if (!area->isVisible()) continue;
        const QRect place(area->mapTo(window_.get(), QPoint(0, 0)), area->size());
        if (place.right() < 0) continue;  // behind a tab
        QVERIFY2(whole.contains(place), qPrintable(QString("%1: %2 %3 %4 %5 in %6 x %7")
                                                       .arg(area->widget()->metaObject()->className())
                                                       .arg(place.left())
                                                       .arg(place.top())
                                                       .arg(place.right())
                                                       .arg(place.bottom())
                                                       .arg(whole.width())
                                                       .arg(whole.height())));
        const bool wide = area->viewport()->width() >= area->widget()->minimumSizeHint().width();
        QVERIFY2(wide || area->horizontalScrollBarPolicy() == Qt::ScrollBarAsNeeded,
                 area->widget()->metaObject()->className());
    }
    openSheet();
    auto* sheet = window_->findChild<TextDialog*>();
    QVERIFY(sheet != nullptr);
    const QSize screen = window_->screen()->size();
    QVERIFY(sheet->width() > 400 && sheet->width() <= screen.width() && sheet->height() <= screen.height());
    QTest::keyClick(sheet, Qt::Key_Escape);
    window_->grab().save(QString::fromStdString((folder_ / "large.png").string()));
    window_->findChild<QMenu*>("textSize")->actions().front()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(window_->fontMetrics().height(), usual, kPatience);
    window_->resize(size);
}

void WindowMenuTest::everySettingIsThereAfterARestart() {
    WindowSettings wanted = window_->settings();
    for (const WindowOption& option : windowOptions()) {
        if (const auto* flag = std::get_if<WindowOption::Switch>(&option.value)) (*flag)(wanted) = !(*flag)(wanted);
        if (const auto* number = std::get_if<WindowOption::Number>(&option.value)) {
            const bool counts = std::string_view(option.key).ends_with("button");
            const double some = option.highest == 1 ? 0.25 : 1.5 < option.highest ? 1.5 : 0.0125;
            (*number)(wanted) = counts ? 4 : std::max(some, 1.5 * option.lowest);
        }
    }
    wanted.mirror.number = std::string("2");
    wanted.bur = std::string("58");
    wanted.secondView = std::string("mesial");
    wanted.notation = std::string("universal");
    const auto file = folder_ / "settings/window.toml";
    QVERIFY(writeWindowSettings(wanted, file).has_value());
    const auto read = readWindowSettings(file);
    QVERIFY2(read.has_value(), read.has_value() ? "" : read.error().message().c_str());
    {
        MainWindow again(*sound_);
        again.apply(*read);
        QVERIFY(writeWindowSettings(again.settings(), file).has_value());
    }
    const auto kept = readWindowSettings(file);
    QVERIFY(kept.has_value());
    WindowSettings got = *kept;
    for (const WindowOption& option : windowOptions()) {
        const QByteArray flag = QByteArray::fromStdString(flagOf(option));
        if (const auto* on = std::get_if<WindowOption::Switch>(&option.value)) {
            QVERIFY2((*on)(got) == (*on)(wanted), flag);
        }
        if (const auto* number = std::get_if<WindowOption::Number>(&option.value)) {
            QVERIFY2(std::abs((*number)(got) - (*number)(wanted)) < 0.006, flag);
        }
    }
    QCOMPARE(got.mirror.number, wanted.mirror.number);
    QCOMPARE(got.bur, wanted.bur);
    QCOMPARE(got.secondView, wanted.secondView);
    QCOMPARE(got.notation, wanted.notation);
    window_->apply(WindowSettings());
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowMenuTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_menu_test.moc"
