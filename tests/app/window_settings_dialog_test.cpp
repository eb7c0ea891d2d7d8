// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dialog with all settings: made from the table of the settings, and acting at once.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>

#include "app/gui/dialogs/key_editor.h"
#include "app/gui/dialogs/settings_dialog.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "support/text_file.h"

namespace tactooth {

class WindowSettingsDialogTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Saves pictures of pages: light, dark, Japanese.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void cleanup();
    void eachSettingOfTheTableHasItsRow();
    void aChangeActsAtOnceAndLeavesTheOthers();
    void aDeviceThatStaysIsNotOpenedAgain();
    void onePageAndAllPagesAreReset();
    void anotherLanguageOpensTheWindowAnew();
    void theKeysAreOneClickAway();
    void theRowsFitIntoASmallScreen();
    void cleanupTestCase();

private:
    SettingsDialog* open();
    template <class Control>
    static Control* control(const SettingsDialog& dialog, const char* flag) {
        return dialog.findChild<Control*>(flag);
    }
    void leave(SettingsDialog* dialog);
    WindowSettings before_;
};

void WindowSettingsDialogTest::initTestCase() {
    openWindowWithSettings();
    waitForTooth();
    before_ = window_->settings();
}

void WindowSettingsDialogTest::cleanupTestCase() { closeWindow(); }

void WindowSettingsDialogTest::cleanup() {
    window_->change(before_);
    waitForTooth();
}

SettingsDialog* WindowSettingsDialogTest::open() {
    key(Qt::Key_Comma, Qt::ControlModifier);
    return window_->findChild<SettingsDialog*>();
}

void WindowSettingsDialogTest::leave(SettingsDialog* dialog) {
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<SettingsDialog*>() == nullptr, kPatience);
}

void WindowSettingsDialogTest::eachSettingOfTheTableHasItsRow() {
    SettingsDialog* dialog = open();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    WindowSettings now = window_->settings();
    int rows = 0;
    for (const WindowOption& option : windowOptions()) {
        const QByteArray flag = QByteArray::fromStdString(flagOf(option));
        auto* shown = dialog->findChild<QWidget*>(QString(flag));
        QVERIFY2((shown != nullptr) == (option.page != SettingsPage::None), flag);
        if (shown == nullptr) continue;
        ++rows;
        QVERIFY2(!shown->accessibleName().isEmpty(), flag);
        if (const auto* on = std::get_if<WindowOption::Switch>(&option.value)) {
            QVERIFY2(qobject_cast<QCheckBox*>(shown)->isChecked() == (*on)(now), flag);
        } else if (const auto* number = std::get_if<WindowOption::Number>(&option.value)) {
            const auto* box = qobject_cast<QDoubleSpinBox*>(shown);
            QVERIFY2(std::abs(box->value() - (*number)(now)) < 0.006, flag);
            QVERIFY2(option.unit == nullptr || box->suffix().contains(option.unit), flag);
        } else if (option.words != nullptr) {
            const QString value = QString::fromStdString(std::get<WindowOption::Text>(option.value)(now));
            QCOMPARE(qobject_cast<QComboBox*>(shown)->currentData().toString(), value);
        }
    }
    QVERIFY2(rows > 45, qPrintable(QString::number(rows)));
    leave(dialog);
}

void WindowSettingsDialogTest::aChangeActsAtOnceAndLeavesTheOthers() {
    SettingsDialog* dialog = open();
    control<QCheckBox>(*dialog, "--view-magnifier")->click();
    QVERIFY(window_->settings().aids.magnifier);
    control<QCheckBox>(*dialog, "--window-dark")->click();
    QVERIFY(QApplication::palette().color(QPalette::Window).lightness() < 100);
    auto* depth = control<QDoubleSpinBox>(*dialog, "--force-depth");
    QTest::keyClick(depth, Qt::Key_Up);
    QCOMPARE(window_->model().manipulator().depthControl().depth(), before_.force.depth + depth->singleStep());
    auto* drive = control<QComboBox>(*dialog, "--drill-drive");
    drive->setFocus();
    QTest::keyClick(drive, Qt::Key_Down);
    QCOMPARE(window_->findChild<DrillBar*>()->spindleName(), QString::fromStdString(spindlePresets()[1].name));
    auto* scaling = control<QDoubleSpinBox>(*dialog, "--hand-fineness");
    scaling->setValue(scaling->minimum());
    QCOMPARE(window_->settings().hand.motionScaling, kAutoScaling);
    control<QDoubleSpinBox>(*dialog, "--recording-gigabytes")->setValue(5);
    WindowSettings wanted = before_;
    wanted.aids.magnifier = wanted.dark = true;
    wanted.force.depth = window_->settings().force.depth;
    wanted.spindle = spindlePresets()[1].name;
    wanted.hand.motionScaling = kAutoScaling;
    wanted.recordingGigabytes = 5;
    leave(dialog);
    WindowSettings got = window_->settings();
    got.docks = wanted.docks;
    got.geometry = wanted.geometry;
    QCOMPARE(windowSettingsText(got), windowSettingsText(wanted));
}

void WindowSettingsDialogTest::aDeviceThatStaysIsNotOpenedAgain() {
    const auto path = folder_ / "path.csv";
    test::writeText(path, "t,x,y,z,qw,qx,qy,qz\n0,0,0,40,1,0,0,0\n600,0,0,41,1,0,0,0\n");
    window_->devices().openFirst("replay:" + QString::fromStdString(path.string()));
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().devices().first() != nullptr, kPatience);
    const HapticDevice* const opened = window_->model().devices().first();
    SettingsDialog* dialog = open();
    control<QDoubleSpinBox>(*dialog, "--hand-fineness")->setValue(2);
    waitForSteps(3);
    QCOMPARE(window_->model().controls.motionScaling, 2.0);
    QVERIFY(window_->model().devices().first() == opened);
    leave(dialog);
    window_->devices().openFirst("mouse");
}

void WindowSettingsDialogTest::onePageAndAllPagesAreReset() {
    SettingsDialog* dialog = open();
    control<QCheckBox>(*dialog, "--view-magnifier")->click();
    control<QDoubleSpinBox>(*dialog, "--force-scale")->setValue(2);
    control<QDoubleSpinBox>(*dialog, "--sound-water")->setValue(0.25);
    auto* pages = dialog->findChild<QListWidget*>("settingsPages");
    pages->setCurrentRow(1);  // View
    QTest::mouseClick(dialog->findChild<QPushButton*>("resetPage"), Qt::LeftButton);
    QVERIFY(!window_->settings().aids.magnifier);
    QCOMPARE(window_->settings().force.scale, 2.0);
    QTest::mouseClick(dialog->findChild<QPushButton*>("resetAll"), Qt::LeftButton);
    QCOMPARE(window_->settings().force.scale, 1.0);
    QCOMPARE(window_->settings().sound.environment, SoundMixer().environment);
    QCOMPARE(control<QDoubleSpinBox>(*dialog, "--force-scale")->value(), 1.0);
    leave(dialog);
}

void WindowSettingsDialogTest::anotherLanguageOpensTheWindowAnew() {
    SettingsDialog* dialog = open();
    QSignalSpy chosen(window_.get(), &MainWindow::languageChosen);
    auto* language = control<QComboBox>(*dialog, "--window-language");
    language->setCurrentIndex(language->findData("ja"));
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(window_->settings().language, std::string("ja"));
    leave(dialog);
}

void WindowSettingsDialogTest::theKeysAreOneClickAway() {
    SettingsDialog* dialog = open();
    QTest::mouseClick(dialog->findChild<QPushButton*>("settingsKeys"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<SettingsDialog*>() == nullptr, kPatience);
    auto* editor = window_->findChild<KeyEditor*>();
    QVERIFY(editor != nullptr && editor->isVisible());
    QTest::keyClick(editor, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<KeyEditor*>() == nullptr, kPatience);
}

void WindowSettingsDialogTest::theRowsFitIntoASmallScreen() {
    SettingsDialog* dialog = open();
    QVERIFY(dialog->minimumSizeHint().width() <= 1024);
    QVERIFY(dialog->minimumSizeHint().height() <= 600);
    leave(dialog);
}

void WindowSettingsDialogTest::savePictures(const QString& folder) {
    initTestCase();
    const auto save = [&](int page, const QString& name) {
        SettingsDialog* dialog = open();
        dialog->findChild<QListWidget*>("settingsPages")->setCurrentRow(page);
        dialog->grab().save(folder + "/settings-" + name + ".png");
        leave(dialog);
    };
    save(0, "appearance");
    save(4, "hand");
    applyColours(true);
    save(3, "force-dark");
    applyColours(false);
    closeWindow();
    applyLanguage(*qApp, "ja");
    openWindowWithSettings();
    save(3, "force-ja");
    save(6, "recording-ja");
    closeWindow();
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowSettingsDialogTest test;
    if (argc == 3 && QString(argv[1]) == "--pictures") return test.savePictures(argv[2]), 0;
    return QTest::qExec(&test, argc, argv);
}

#include "window_settings_dialog_test.moc"
