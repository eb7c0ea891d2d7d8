// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// As a teacher would: a surface is dropped on the real window, what was assumed is shown, changed and taken.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <cmath>
#include <fstream>
#include <numbers>

#include "app/gui/dialogs/case_dialog.h"
#include "app/gui/dialogs/import_dialog.h"
#include "app/gui/dialogs/scan_preview.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "geometry/io/stl_writer.h"
#include "instruments/builtin_tooth.h"
#include "session/cases/make_case.h"
#include "session/cases/open_case.h"
#include "session/cases/write_case.h"
#include "support/shapes.h"

namespace tactooth {

class ImportWindowTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Writes a picture of the dialog in front of the window.
    bool saveScreenshot(const QString& file, const QString& scan);

private slots:
    void initTestCase();
    void aDroppedSurfaceIsShownBeforeItIsTaken();
    void aChoiceIsFollowed();
    void theScanIsShownTurningUntilSomebodyTakesHoldOfIt();
    void aClickOnTheCheekTurnsTheScan();
    void theWindowStaysAliveWhileTheLayersAreMade();
    void anImportIsInTheRecentMenu();
    void theImportCanBeCancelled();
    void aSurfaceThatCannotBeReadIsRefused();
    void theSameLayerOfTwoTeethIsRefused();
    void aWideHoleIsFilledWhenChosen();
    void aDroppedCaseIsOpenedAndItsTeethCanBeChosen();
    void aDroppedFolderOfScansBecomesACase();
    void inJapaneseACaseSaysInJapaneseWhatWasAssumed();
    void aFolderWithoutATooth();
    void aCaseThatCannotBeWrittenStaysShown();
    void cleanupTestCase();

private:
    void drop(const std::vector<std::filesystem::path>& files);
    [[nodiscard]] ImportDialog* dialog() const { return window_->findChild<ImportDialog*>(); }
    [[nodiscard]] QPushButton* importButton() const {
        return dialog()->findChild<QDialogButtonBox*>("importButtons")->button(QDialogButtonBox::Ok);
    }
    [[nodiscard]] QString importNotes() const {
        return dialog()->findChild<QTextBrowser*>("importNotes")->toPlainText();
    }
    [[nodiscard]] CaseDialog* caseDialog() const { return window_->findChild<CaseDialog*>(); }
    [[nodiscard]] QPushButton* caseButton() const {
        return caseDialog()->findChild<QDialogButtonBox*>("caseButtons")->button(QDialogButtonBox::Ok);
    }
    [[nodiscard]] QString caseNotes() const {
        return caseDialog()->findChild<QTextBrowser*>("caseNotes")->toPlainText();
    }
    void writeBlocks(const std::string& folder) const;
    void saveCaseAs(const std::filesystem::path& file);
    void waitForImportNotes(const QString& words);
    void waitForToothNamed(const std::string& name);

    std::filesystem::path scan_;
};

void ImportWindowTest::drop(const std::vector<std::filesystem::path>& files) {
    QMimeData data;
    QList<QUrl> urls;
    for (const auto& file : files) urls += QUrl::fromLocalFile(QString::fromStdString(file.string()));
    data.setUrls(urls);
    const QPoint place = window_->rect().center();
    QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window_.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(place, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window_.get(), &drop);
}

void ImportWindowTest::waitForImportNotes(const QString& words) {
    QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr && importButton()->isEnabled() && importNotes().contains(words),
                             kLoadPatience);
}

void ImportWindowTest::waitForToothNamed(const std::string& name) {
    QTRY_VERIFY_WITH_TIMEOUT(
        !window_->isBusy() && window_->model().runner() != nullptr && window_->model().tooth()->name == name,
        kLoadPatience);
}

void ImportWindowTest::initTestCase() {
    // A molar in centimetres, lying on its side.
    const BuiltinTooth molar = makeTooth({.fdi = 36, .triangles = 3000, .seed = 0, .lesion = {}});
    const Quat lie(Eigen::AngleAxisd(1.5708, Vec3::UnitX()));
    TriangleMesh mesh = transformed(molar.outer, {Vec3(20, 0, 5), lie});
    for (Vec3f& vertex : mesh.vertices) vertex *= 0.1F;
    scan_ = folder_ / "molar.stl";
    QVERIFY(writeStl(mesh, scan_).has_value());
    openWindow();
}

void ImportWindowTest::aDroppedSurfaceIsShownBeforeItIsTaken() {
    drop({scan_});
    QVERIFY(dialog() != nullptr);
    waitForImportNotes("Units taken as cm");
    QVERIFY2(importNotes().contains("to stand crown up"), qPrintable(importNotes()));
    QVERIFY2(importNotes().contains("closed and sound as it came"), qPrintable(importNotes()));
    QVERIFY(window_->model().tooth() == std::nullopt || window_->model().tooth()->name != "molar.stl");
}

void ImportWindowTest::aChoiceIsFollowed() {
    dialog()->findChild<QCheckBox*>("upsideDown")->click();
    waitForImportNotes("Turned upside down, as chosen.");
    dialog()->findChild<QCheckBox*>("upsideDown")->click();
    QTRY_VERIFY_WITH_TIMEOUT(importButton()->isEnabled() && !importNotes().contains("upside down"), kLoadPatience);
    auto* units = dialog()->findChild<QComboBox*>("units");
    units->setCurrentIndex(units->findText("inch"));
    waitForImportNotes("Scaled by 25.40000, as chosen");
    units->setCurrentIndex(0);
    waitForImportNotes("Units taken as cm");
}

void ImportWindowTest::theScanIsShownTurningUntilSomebodyTakesHoldOfIt() {
    auto* preview = dialog()->findChild<ScanPreview*>();
    QVERIFY(preview->isTurning());
    const double before = preview->eye().direction().azimuth;
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(preview->eye().direction().azimuth - before) > 0.02, kPatience);
    const QImage picture = preview->grabFramebuffer();
    const QColor ground = picture.pixelColor(2, 2);
    int other = 0;
    for (int x = 0; x < picture.width(); x += 4) {
        for (int y = 0; y < picture.height(); y += 4) other += picture.pixelColor(x, y) != ground ? 1 : 0;
    }
    QVERIFY2(other > picture.width() * picture.height() / 16 / 10, "the tooth fills a part of it");
    const QPoint place = preview->rect().center();
    QTest::mousePress(preview, Qt::LeftButton, {}, place);
    QVERIFY(!preview->isTurning());
    const double held = preview->eye().direction().azimuth;
    QMouseEvent drag(QEvent::MouseMove, place + QPoint(40, 0), preview->mapToGlobal(place), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(preview, &drag);
    QTest::mouseRelease(preview, Qt::LeftButton, {}, place + QPoint(40, 0));
    QVERIFY(std::abs(preview->eye().direction().azimuth - held) > 0.05);
    QCOMPARE(dialog()->findChild<QDoubleSpinBox*>("turn")->value(), 0.0);  // a drag is no click
    QVERIFY(!preview->isTurning());
}

void ImportWindowTest::aClickOnTheCheekTurnsTheScan() {
    auto* preview = dialog()->findChild<ScanPreview*>();
    auto* turn = dialog()->findChild<QDoubleSpinBox*>("turn");
    // What is nearest to the eye is at the eye's azimuth.
    const double azimuth = preview->eye().direction().azimuth * 180 / std::numbers::pi;
    QTest::mouseClick(preview, Qt::LeftButton, {}, preview->rect().center());
    QVERIFY2(std::abs(std::remainder(turn->value() - (90 - azimuth), 360)) < 15, qPrintable(turn->text()));
    waitForImportNotes("about the long axis");
    turn->setValue(0);
    QTRY_VERIFY_WITH_TIMEOUT(importButton()->isEnabled() && !importNotes().contains("about the long axis"),
                             kLoadPatience);
}

void ImportWindowTest::theWindowStaysAliveWhileTheLayersAreMade() {
    constexpr int kTries = 5;  // a busy machine may keep the window from all that happens in one import
    bool isAlive = false;
    for (int i = 0; i < kTries && !isAlive; ++i) {
        if (i > 0) {
            drop({scan_});
            waitForImportNotes("Units taken as cm");
        }
        if (i == 0) dialog()->findChild<QCheckBox*>("keepCase")->click();
        // A full-quality picture that is still to come could block the event loop too.
        QTRY_VERIFY_WITH_TIMEOUT(view().isAtRest(), kPatience);
        importButton()->click();
        int turns = 0;  // of the event loop, which the work must not block
        double part = 0;
        QElapsedTimer passed;
        passed.start();
        for (; dialog() != nullptr && passed.elapsed() < kLoadPatience; ++turns) {
            const auto* progress = dialog()->findChild<QProgressBar*>("importProgress");
            part = std::max(part, static_cast<double>(progress->value()) / progress->maximum());
            QTest::qWait(5);
        }
        QVERIFY(dialog() == nullptr);
        constexpr qint64 kTooQuickToTell = 300;  // ms, as long as one or two pictures on a busy machine
        // One turn if the work had blocked it.
        isAlive = (turns > 1 && part > 0.05) || passed.elapsed() < kTooQuickToTell;
        waitForToothNamed("molar.stl");
    }
    QVERIFY(isAlive);
    const SessionTooth& tooth = *window_->model().tooth();
    QVERIFY(tooth.box().sizes().z() > 15 && tooth.box().sizes().z() < 30);
    QCOMPARE(tooth.piece->tooth().layers().size(), std::size_t{3});
    const auto kept = openCase(folder_ / "molar.ttcase");
    QVERIFY2(kept.has_value(), kept ? "" : kept.error().message().c_str());
    QVERIFY(kept->description.teeth.front().isModelled);
    QVERIFY(window_->settings().recent.starts_with((folder_ / "molar.ttcase").string()));
}

void ImportWindowTest::anImportIsInTheRecentMenu() {
    drop({scan_});
    waitForImportNotes("Units taken as cm");
    QVERIFY(!dialog()->findChild<QCheckBox*>("keepCase")->isChecked());
    importButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kLoadPatience);
    waitForToothNamed("molar.stl");
    auto* recent = window_->findChild<QMenu*>("recent");
    emit recent->aboutToShow();
    QCOMPARE(recent->actions().front()->text(), QString("Import molar.stl…"));
    QCOMPARE(recent->actions().front()->statusTip(), QString::fromStdString(scan_.string()));
    recent->actions().front()->trigger();
    waitForImportNotes("Units taken as cm");
    dialog()->reject();
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatience);
}

void ImportWindowTest::theImportCanBeCancelled() {
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    waitForToothNamed(std::string(kBuiltinTeeth.front().name));
    drop({scan_});
    waitForImportNotes("Units taken as cm");
    importButton()->click();
    dialog()->findChild<QDialogButtonBox*>("importButtons")->button(QDialogButtonBox::Cancel)->click();
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->teeth().isImporting(), kPatience);
    waitForSteps(2);
    QCOMPARE(window_->model().tooth()->name, std::string(kBuiltinTeeth.front().name));
    QVERIFY(window_->findChild<QMessageBox*>() == nullptr);
}

void ImportWindowTest::aSurfaceThatCannotBeReadIsRefused() {
    const auto file = folder_ / "garbage.stl";
    std::ofstream(file) << "this is no surface at all";
    drop({file});
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    auto* box = window_->findChild<QMessageBox*>();
    QVERIFY2(box->text().contains("garbage.stl"), qPrintable(box->text()));
    delete box;
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatience);
}

void ImportWindowTest::theSameLayerOfTwoTeethIsRefused() {
    for (const char* const name : {"L6_enamel.stl", "L7_enamel.stl"}) {
        QVERIFY(writeStl(test::box(Vec3(-4, -4, -12), Vec3(4, 4, 8)), folder_ / name).has_value());
    }
    drop({folder_ / "L6_enamel.stl", folder_ / "L7_enamel.stl"});
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    const QString said = dismissMessage();
    QVERIFY2(said.contains("L7_enamel.stl: the tooth has this surface already"), qPrintable(said));
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatience);
}

void ImportWindowTest::aWideHoleIsFilledWhenChosen() {
    TriangleMesh open = test::box(Vec3(-3, -3, -12), Vec3(3, 3, 8));
    open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);
    const auto file = folder_ / "open.stl";
    QVERIFY(writeStl(open, file).has_value());
    drop({file});
    QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr && importNotes().contains("too wide to be filled unasked"),
                             kLoadPatience);
    QVERIFY(!importButton()->isEnabled());
    dialog()->findChild<QComboBox*>("holes")->setCurrentIndex(1);
    waitForImportNotes("1 holes were filled");
    dialog()->reject();
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatience);
}

/// Two teeth with their dentin, as a scanner's program leaves them.
void ImportWindowTest::writeBlocks(const std::string& folder) const {
    const auto path = folder_ / folder;
    std::filesystem::create_directories(path);
    for (const auto& [name, x] : {std::pair("L6", 0.0), std::pair("L7", 10.0)}) {
        const TriangleMesh block = test::box(Vec3(x - 4, -4, -12), Vec3(x + 4, 4, 8));
        QVERIFY(writeStl(block, path / std::string(name).append("_outer.stl")).has_value());
        const TriangleMesh core = test::box(Vec3(x - 3, -3, -11), Vec3(x + 3, 3, 5));
        QVERIFY(writeStl(core, path / std::string(name).append("_dentin.stl")).has_value());
    }
}

void ImportWindowTest::saveCaseAs(const std::filesystem::path& file) {
    caseButton()->click();
    auto* dialog = window_->findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr);
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(QString::fromStdString(file.string()));
    QMetaObject::invokeMethod(dialog, "accept");
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() == nullptr, kPatience);
}

void ImportWindowTest::aDroppedFolderOfScansBecomesACase() {
    writeBlocks("patient");
    drop({folder_ / "patient"});
    QVERIFY(caseDialog() != nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(caseButton()->isEnabled(), kLoadPatience);
    QVERIFY2(caseNotes().contains("L6") && caseNotes().contains("L7"), qPrintable(caseNotes()));
    QVERIFY(caseNotes().contains("L6, number unknown"));
    auto* quadrant = caseDialog()->findChild<QComboBox*>("quadrant");
    quadrant->setCurrentIndex(quadrant->findData(3));
    QVERIFY(!caseButton()->isEnabled());  // it is made again
    QTRY_VERIFY_WITH_TIMEOUT(caseButton()->isEnabled() && caseNotes().contains("tooth 36 (FDI)"), kLoadPatience);
    const auto file = folder_ / "patient.ttcase";
    QVERIFY(!std::filesystem::exists(file));
    caseButton()->click();
    auto* dialog = window_->findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr);
    QCOMPARE(dialog->selectedFiles().front(), QString::fromStdString(file.string()));  // beside the folder
    QMetaObject::invokeMethod(dialog, "accept");
    QTRY_VERIFY_WITH_TIMEOUT(caseDialog() == nullptr, kLoadPatience);
    waitForToothNamed("patient, L6");
    QCOMPARE(openCase(file).value().description.teeth.back().fdi, 37);
    // The next case of that folder gets a name of its own.
    drop({folder_ / "patient"});
    QTRY_VERIFY_WITH_TIMEOUT(caseButton()->isEnabled(), kLoadPatience);
    caseButton()->click();
    dialog = window_->findChild<QFileDialog*>();
    QCOMPARE(dialog->selectedFiles().front(), QString::fromStdString((folder_ / "patient-2.ttcase").string()));
    dialog->reject();
    caseDialog()->reject();
    QTRY_VERIFY_WITH_TIMEOUT(caseDialog() == nullptr && !window_->teeth().isImporting(), kLoadPatience);
}

void ImportWindowTest::inJapaneseACaseSaysInJapaneseWhatWasAssumed() {
    writeBlocks("japanese");
    QVERIFY(writeStl(test::box(Vec3(-9, -9, -30), Vec3(19, 9, -13)), folder_ / "japanese/bone.stl").has_value());
    const auto made = makeCase({.from = {folder_ / "japanese"}, .quadrant = 3});
    QVERIFY2(made.has_value(), made ? "" : made.error().message().c_str());
    applyLanguage(*qApp, "ja");
    CaseDialog shown("japanese");
    shown.setAttribute(Qt::WA_DeleteOnClose, false);
    shown.showCase(made);
    applyLanguage(*qApp, "en");
    const QString notes = shown.findChild<QTextBrowser*>("caseNotes")->toPlainText();
    QVERIFY2(notes.contains(QStringLiteral("元から閉じていて、問題はありません。")), qPrintable(notes));
    for (const auto& body : made->description.teeth) {
        for (const std::string& english : body.assumed) {
            QVERIFY2(!notes.contains(QString::fromStdString(english)), english.c_str());
        }
    }
}

void ImportWindowTest::aFolderWithoutATooth() {
    std::filesystem::create_directories(folder_ / "empty");
    drop({folder_ / "empty"});
    QTRY_VERIFY_WITH_TIMEOUT(!caseNotes().isEmpty(), kLoadPatience);
    QVERIFY2(caseNotes().contains("no STL, OBJ or PLY file"), qPrintable(caseNotes()));
    QVERIFY(!caseButton()->isEnabled());
    caseDialog()->reject();
    QTRY_VERIFY_WITH_TIMEOUT(caseDialog() == nullptr, kPatience);
}

void ImportWindowTest::aCaseThatCannotBeWrittenStaysShown() {
    writeBlocks("other");
    drop({folder_ / "other"});
    QTRY_VERIFY_WITH_TIMEOUT(caseButton()->isEnabled(), kLoadPatience);
    saveCaseAs(folder_ / "no such folder" / "other.ttcase");
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    QVERIFY(dismissMessage().contains("no such folder"));
    QVERIFY(caseDialog() != nullptr && caseButton()->isEnabled());
    caseDialog()->reject();
    QTRY_VERIFY_WITH_TIMEOUT(caseDialog() == nullptr, kPatience);
}

void ImportWindowTest::aDroppedCaseIsOpenedAndItsTeethCanBeChosen() {
    writeBlocks("scans");
    const auto made = makeCase({.from = {folder_ / "scans"}, .title = "Blocks", .quadrant = 3});
    QVERIFY2(made.has_value(), made ? "" : made.error().message().c_str());
    QVERIFY(writeCase(made->files, folder_ / "blocks.ttcase").has_value());
    drop({folder_ / "blocks.ttcase"});
    waitForToothNamed("Blocks, L6");
    QVERIFY(dialog() == nullptr);
    auto* menu = window_->findChild<QMenu*>("teethOfCase");
    emit menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 2);
    menu->actions().back()->trigger();
    waitForToothNamed("Blocks, L7");
}

void ImportWindowTest::cleanupTestCase() { closeWindow(); }

bool ImportWindowTest::saveScreenshot(const QString& file, const QString& scan) {
    initTestCase();
    waitForToothNamed(std::string(kBuiltinTeeth.front().name));
    drop({scan.isEmpty() ? scan_ : std::filesystem::path(scan.toStdString())});
    QElapsedTimer since;
    for (since.start(); since.elapsed() < kLoadPatience && !importButton()->isEnabled();) QTest::qWait(50);
    QPixmap picture = window_->grab();
    dialog()->render(&picture, dialog()->pos() - window_->pos());
    const bool saved = picture.save(file);
    dialog()->reject();
    cleanupTestCase();
    return saved;
}

}  // namespace tactooth

/// `import_window_tests --screenshot FILE.png [SCAN]` writes a picture instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::ImportWindowTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--screenshot")
        return test.saveScreenshot(arguments.value(2), arguments.value(3)) ? 0 : 1;
    return QTest::qExec(&test, argc, argv);
}

#include "import_window_test.moc"
