// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A teacher makes an exercise in the window by clicks alone, tries it, saves it, and opens it again.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>

#include "app/gui/editor/editor_panel.h"
#include "app/gui/editor/editor_session.h"
#include "app/gui/window/window_owner.h"
#include "assessment/allowed_instruments.h"
#include "assessment/exercise_file.h"
#include "collision/bvh/closest_point.h"
#include "geometry/mesh/mesh_report.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

}  // namespace

class WindowEditorTest : public test::EditorSession {
    Q_OBJECT

public:
    /// Pictures to look at.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void theMenuBeginsANewExerciseOnTheToothOfTheBench();
    void aTemplateDrawsAClassTwoCavityAtOnce();
    void aDragMovesAPointAndUndoTakesItBack();
    void clicksAddAndRemovePoints();
    void theLineUnderTheButtonsSaysWhatIsWrong();
    void aForbiddenZoneIsDrawnOnAnotherSide();
    void fieldsChangeTheCavity();
    void theTeacherSaysWhatTheStudentMayTake();
    void theTeacherTriesItAndComesBack();
    void whatIsNotSavedIsAskedAbout();
    void itIsSavedAndStandsAmongYourOwn();
    void theSavedExerciseHasTheIdealThatWasDrawn();
    void aCopyOfABuiltInOneIsEdited();
    void anotherToothBringsAnotherOutline();
    void aFreeOutlineIsClosedAtItsFirstPoint();
    void anotherLanguageKeepsTheDraft();
    void cleanupTestCase();

private:
    void chooseInDialog(const fs::path& file) const;

    fs::path file_;
};

void WindowEditorTest::initTestCase() { openEditorWindow(); }

void WindowEditorTest::cleanupTestCase() { closeWindow(); }

void WindowEditorTest::chooseInDialog(const fs::path& file) const {
    QFileDialog* dialog = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((dialog = window_->findChild<QFileDialog*>()) != nullptr, kPatience);
    if (!file.empty()) dialog->findChild<QLineEdit*>("fileNameEdit")->setText(QString::fromStdString(file.string()));
    QMetaObject::invokeMethod(dialog, "accept");
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() == nullptr, kPatience);
}

void WindowEditorTest::theMenuBeginsANewExerciseOnTheToothOfTheBench() {
    QVERIFY(window_->findChild<EditorPanel*>() == nullptr);
    chooseEntry("exerciseMenu", "newExercise");
    waitForEditor();
    QVERIFY(window_->findChild<EditorPanel*>()->isVisible());
    QCOMPARE(std::get<ToothRequest>(draft().exercise().tooth).fdi, 46);
    QVERIFY(problem().startsWith("Draw the outline"));
    QVERIFY(!window_->findChild<QPushButton*>("editTry")->isEnabled());
    QVERIFY(!window_->isWindowModified());
}

void WindowEditorTest::aTemplateDrawsAClassTwoCavityAtOnce() {
    click("templateClassTwoMesial");
    QCOMPARE(problem(), "The exercise is complete.");
    QCOMPARE(plan().boxes.size(), std::size_t{1});
    QCOMPARE(draft().exercise().group, ExerciseGroup::ClassTwo);
    QVERIFY(points().size() >= 6);
    const OutlineMarks& marks = view().outlines().marks(OutlineOverlay::Layer::Editor);
    QCOMPARE(marks.lines.size(), std::size_t{2});  // outline and box
    QCOMPARE(marks.lines[0].handles.size(), points().size());
    for (const Vec3& point : points()) QVERIFY(view().rect().contains(pixelOf(point)));
    QTRY_VERIFY_WITH_TIMEOUT(window_->isWindowModified(), kPatience);
}

void WindowEditorTest::aDragMovesAPointAndUndoTakesItBack() {
    const std::vector<Vec3> before = points();
    const QPoint from = pixelOf(before[1]), to = from + QPoint(0, 14);
    QTest::mouseMove(&view(), from);
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 7; ++i) QTest::mouseMove(&view(), from + QPoint(0, 2 * i));
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    QVERIFY(!window_->model().manipulator().isPressing());
    QCOMPARE(points().size(), before.size());
    QVERIFY((points()[1] - before[1]).norm() > 0.1);
    QVERIFY((pixelOf(points()[1]) - to).manhattanLength() <= 8);
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(points() == before);  // the whole drag
    click("editRedo");
    QVERIFY(points() != before);
    QCOMPARE(problem(), "The exercise is complete.");
}

void WindowEditorTest::clicksAddAndRemovePoints() {
    const std::vector<Vec3> before = points();
    const QPoint place = (pixelOf(before[1]) + pixelOf(before[2])) / 2;
    clickAt(place);
    QCOMPARE(points().size(), before.size() + 1);
    QVERIFY((pixelOf(points()[2]) - place).manhattanLength() <= 3);
    QTest::mouseClick(&view(), Qt::RightButton, {}, pixelOf(points()[2]));
    QVERIFY(points() == before);
    clickAt(place);
    QTest::mouseMove(&view(), place);
    QTest::keyClick(&view(), Qt::Key_Delete);
    QVERIFY(points() == before);
    const OrbitCamera::Direction direction = view().orbitCamera().direction();
    QTest::mouseClick(&view(), Qt::RightButton, {}, QPoint(5, 5));  // beside all points
    QVERIFY(points() == before);
    QCOMPARE(view().orbitCamera().direction().azimuth, direction.azimuth);
}

void WindowEditorTest::theLineUnderTheButtonsSaysWhatIsWrong() {
    const std::vector<Vec3> before = points();
    const QPoint from = pixelOf(before[1]), across = pixelOf(before[before.size() - 2]);
    const QPoint to = from + (across - from) * 9 / 5;  // beyond the other side
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&view(), (from + to) / 2);
    QTest::mouseMove(&view(), to);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    QCOMPARE(problem(), "The outline crosses itself.");
    QVERIFY(!window_->findChild<QPushButton*>("editSave")->isEnabled());
    click("editUndo");
    QVERIFY(points() == before);
    QCOMPARE(problem(), "The exercise is complete.");
}

void WindowEditorTest::aForbiddenZoneIsDrawnOnAnotherSide() {
    click("newZone");
    QVERIFY(window_->findChild<QRadioButton*>("drawZone")->isChecked());
    const QPoint cusp = middle() + QPoint(0, 90);
    const std::vector<QPoint> corners = {cusp, cusp + QPoint(40, 0), cusp + QPoint(40, 30)};
    for (const QPoint& corner : corners) clickAt(corner);
    QVERIFY(problem().startsWith("Click the first point"));
    clickAt(corners.front());
    QCOMPARE(problem(), "The exercise is complete.");
    QCOMPARE(draft().exercise().forbidden.size(), std::size_t{1});
    QCOMPARE(draft().exercise().forbidden[0].corners.size(), std::size_t{3});
    click("newZone");
    QCOMPARE(draft().exercise().forbidden.size(), std::size_t{2});
    click("removeZone");
    QCOMPARE(draft().exercise().forbidden.size(), std::size_t{1});
    click("drawOutline");
}

void WindowEditorTest::fieldsChangeTheCavity() {
    setNumber("editDepth", 1.8);
    QCOMPARE(plan().depth, 1.8);
    QVERIFY(draft().exercise().task.find("1.8 mm deep") != std::string::npos);
    setNumber("editTaper", 3);
    QCOMPARE(plan().outline->taperDegrees, 3.0);
    setNumber("editMesialAxialHeight", 1.1);
    QCOMPARE(plan().boxes[0].axialHeight, 1.1);
    setNumber("editMinutes", 12);
    QCOMPARE(*draft().exercise().minutes, 12);
    auto* name = window_->findChild<QLineEdit*>("editName");
    name->selectAll();
    QTest::keyClicks(name, "Our MO cavity");
    QCOMPARE(draft().exercise().name, std::string("Our MO cavity"));
    click("editUndo");  // all letters at once
    QVERIFY(draft().exercise().name != "Our MO cavity");
    click("editRedo");
    QCOMPARE(name->text(), "Our MO cavity");
    click("editDistalBox");
    QVERIFY2(problem().contains("distal box"), qPrintable(problem()));
    click("editDistalBox");
    QCOMPARE(problem(), "The exercise is complete.");
}

void WindowEditorTest::theTeacherSaysWhatTheStudentMayTake() {
    QVERIFY(!draft().exercise().onlyTheseBurs);
    click("editOnlyTheseBurs");
    QVERIFY(draft().exercise().onlyTheseBurs);
    auto& list = *window_->findChild<QListWidget*>("editInstruments");
    const auto set = [&list](const QString& title, bool on) {
        const QList<QListWidgetItem*> found = list.findItems(title, Qt::MatchStartsWith);
        QCOMPARE(found.size(), 1);
        found.front()->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    };
    set("Periodontal", false);
    QCOMPARE(instrumentNames(draft().exercise()), std::string("turbine, contra-angle, low-speed, explorer, excavator"));
    set("Periodontal", true);
    QVERIFY(draft().exercise().instruments.empty());  // all
    click("editUndo");
    QCOMPARE(list.findItems("Periodontal", Qt::MatchStartsWith).front()->checkState(), Qt::Unchecked);
    for (const QString& drive : {list.item(1)->text(), list.item(2)->text()}) set(drive, false);
    QCOMPARE(instrumentNames(draft().exercise()), std::string("turbine, explorer, excavator"));
    QVERIFY(!list.item(0)->flags().testFlag(Qt::ItemIsUserCheckable));  // the last handpiece stays
    set(list.item(1)->text(), true);
    QVERIFY(list.item(0)->flags().testFlag(Qt::ItemIsUserCheckable));
    QCOMPARE(problem(), "The exercise is complete.");
}

void WindowEditorTest::theTeacherTriesItAndComesBack() {
    const Exercise before = draft().exercise();
    const auto* choice = window_->findChild<QComboBox*>("exercise");
    const int listed = choice->count();
    click("editTry");
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() != nullptr, kLoadPatience);
    waitForTooth();
    QCOMPARE(window_->exercise().active()->name, before.name);
    QCOMPARE(choice->currentText(), "Our MO cavity (usual)");
    QVERIFY(view().outlines().marks(OutlineOverlay::Layer::Editor).lines.empty());
    QCOMPARE(view().outlines().marks(OutlineOverlay::Layer::Exercise).lines.size(), std::size_t{1});  // the zone
    QVERIFY(QString::fromStdString(window_->model().bur()->name).contains("245"));
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QCheckBox*>("ghost")->isChecked(), kLoadPatience);
    cutALittle();
    click("editBack");
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() == nullptr, kLoadPatience);
    waitForTooth();
    QVERIFY(unsavedQuestion() == nullptr);
    QVERIFY(draft().exercise() == before);
    QVERIFY(window_->findChild<QPushButton*>("editTry")->isVisible());
    QCOMPARE(removed(), 0.0);
    QCOMPARE(choice->count(), listed);  // a trial is no exercise of the list
}

void WindowEditorTest::whatIsNotSavedIsAskedAbout() {
    click("editClose");
    answer(QMessageBox::Cancel);
    QVERIFY(window_->editor().isEditing());
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth[1]);
    answer(QMessageBox::Cancel);
    QVERIFY(window_->editor().isEditing());
    QVERIFY(!window_->close());
    answer(QMessageBox::Cancel);
    QVERIFY(window_->isVisible() && window_->editor().isEditing());
}

void WindowEditorTest::itIsSavedAndStandsAmongYourOwn() {
    click("editSave");
    chooseInDialog({});  // as proposed
    file_ = folder_ / "data" / "tactooth" / "exercises" / "Our MO cavity.toml";
    QVERIFY(fs::exists(file_));
    QVERIFY(!draft().isModified());
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kPatience);
    auto* own = window_->findChild<QMenu*>("ownExercises");
    emit own->aboutToShow();
    QCOMPARE(own->actions().size(), 1);
    QCOMPARE(own->actions().front()->text(), "Our MO cavity");
    click("editClose");
    QVERIFY(question() == nullptr);
    QVERIFY(!window_->editor().isEditing());
    QVERIFY(!window_->findChild<EditorPanel*>()->isVisible());
    own->actions().front()->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() != nullptr, kLoadPatience);
    waitForTooth();
    QCOMPARE(window_->exercise().active()->file, file_);
    // The mouse holds the bur again.
    pressBurOn(middle());
    QVERIFY(window_->model().manipulator().isPressing());
    liftBur(middle());
}

/// As the command `exercise` reads it.
void WindowEditorTest::theSavedExerciseHasTheIdealThatWasDrawn() {
    const Expected<Exercise> read = findExercise(file_.string());
    QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
    QVERIFY(*read == *window_->exercise().active());
    const auto tooth = *exerciseTooth(*read);
    const auto ideal = idealShape(*read, tooth);
    QVERIFY2(ideal.has_value(), ideal ? "" : ideal.error().message().c_str());
    const MeshReport report = reportOn(*ideal);
    QVERIFY(report.watertight());
    const double volume = *reportOn(tooth->ownOuter()->mesh()).volume() - *report.volume();
    QVERIFY2(volume > 10 && volume < 40, qPrintable(QString::number(volume)));
    double lowest = 100;  // of all walls: the floor of the box
    const auto outer = tooth->ownOuter();
    const CavityWalls walls = cavityWalls(*ideal, *outer);
    for (const Vec3f& vertex : walls.mesh.vertices) {
        const bool isInside = signedDistance(*outer, vertex.cast<double>()) < -0.6;  // away from its rim
        if (isInside) lowest = std::min<double>(lowest, vertex.z());
    }
    const auto reference = floorReference(std::get<PreparationPlan>(read->ideal), *tooth);
    QVERIFY(reference.has_value());
    const double depth = reference->z() - lowest;
    QVERIFY2(std::abs(depth - (1.8 + 1.1)) < 0.1, qPrintable(QString::number(depth)));
}

void WindowEditorTest::aCopyOfABuiltInOneIsEdited() {
    window_->exercise().start(builtinExercise("class-1-46"));
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() == builtinExercise("class-1-46"), kLoadPatience);
    waitForTooth();
    chooseEntry("exerciseMenu", "copyExerciseEntry");
    QInputDialog* dialog = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((dialog = window_->findChild<QInputDialog*>("copyExercise")) != nullptr, kPatience);
    QVERIFY(dialog->textValue().contains("Class I"));
    for (int i = 0; i < dialog->comboBoxItems().size(); ++i) {
        if (dialog->comboBoxItems()[i].contains("36, in the mouth")) dialog->setTextValue(dialog->comboBoxItems()[i]);
    }
    dialog->accept();
    waitForEditor();
    QVERIFY(plan().outline.has_value() && !plan().fissure);
    QVERIFY(draft().exercise().inMouth);
    QCOMPARE(problem(), "The exercise is complete.");
    QVERIFY(!draft().isModified());
    // A click on the tooth beside adds nothing.
    const std::size_t count = points().size();
    clickAt(QPoint(3, 3));
    QCOMPARE(points().size(), count);
    click("editClose");
    QVERIFY(!window_->editor().isEditing());
}

void WindowEditorTest::anotherToothBringsAnotherOutline() {
    loadMolar();
    chooseEntry("exerciseMenu", "newExercise");
    waitForEditor();
    auto* tooth = window_->findChild<QComboBox*>("editTooth");
    for (int i = 0; i < tooth->count(); ++i) {
        if (tooth->itemText(i).startsWith("45")) tooth->setCurrentIndex(i);
    }
    const CutModel* const before = window_->model().tooth()->piece.get();
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().tooth()->piece.get() != before, kLoadPatience);
    waitForTooth();
    QVERIFY(window_->editor().isEditing());
    click("templateClassOne");
    QCOMPARE(problem(), "The exercise is complete.");
    QCOMPARE(draft().exercise().name, std::string("Class I, 45"));
    for (const Vec3& point : points()) QVERIFY(std::abs(point.x()) < 4);
}

void WindowEditorTest::aFreeOutlineIsClosedAtItsFirstPoint() {
    click("freeOutline");
    QVERIFY(points().empty());
    view().setView(StandardView::Buccal);
    const QPoint centre = middle();
    const std::vector<QPoint> corners = {centre, centre + QPoint(120, 0), centre + QPoint(120, 100),
                                         centre + QPoint(0, 100)};
    for (const QPoint& corner : corners) clickAt(corner);
    QCOMPARE(points().size(), std::size_t{4});
    QCOMPARE(plan().outward, Vec3(Vec3::UnitY()));
    QVERIFY(draft().openLine().has_value());
    clickAt(corners.front());
    QCOMPARE(points().size(), std::size_t{4});
    QCOMPARE(problem(), "The exercise is complete.");
}

void WindowEditorTest::anotherLanguageKeepsTheDraft() {
    const Exercise before = draft().exercise();
    auto state = window_->releaseSession();
    QVERIFY(state.draft.has_value());
    window_ = std::make_unique<MainWindow>(*sound_);
    window_->restoreSession(std::move(state));
    window_->show();
    waitForEditor();
    QVERIFY(draft().exercise() == before);
    QVERIFY(draft().isModified());
    click("editClose");
    answer(QMessageBox::Discard);
    QVERIFY(!window_->editor().isEditing());
}

void WindowEditorTest::savePictures(const QString& folder) {
    initTestCase();
    const auto save = [&](const char* name) {
        (void)waitForQuietPicture();
        window_->grab().save(folder + '/' + name + ".png");
    };
    chooseEntry("exerciseMenu", "newExercise");
    waitForEditor();
    save("editor-new");
    click("templateClassTwoMesial");
    save("editor-class-2");
    click("newZone");
    const QPoint cusp = middle() + QPoint(0, 90);
    for (const QPoint& corner : {cusp, cusp + QPoint(60, 0), cusp + QPoint(60, 40), cusp}) clickAt(corner);
    save("editor-zone");
    click("editTry");
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() != nullptr, kLoadPatience);
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QCheckBox*>("ghost")->isChecked(), kLoadPatience);
    save("editor-trial");
    const QRect legend = view().findChild<QWidget*>("colourLegend")->geometry();
    QVERIFY2(!view().findChild<QWidget*>("scaleBarMark")->geometry().intersects(legend), "the picture is narrow here");
    click("editBack");
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() == nullptr, kLoadPatience);
    waitForTooth();
    click("templateClassFive");
    save("editor-class-5");
    window_->findChild<QScrollArea*>("editorArea")->ensureWidgetVisible(window_->findChild<QComboBox*>("editRubric"));
    save("editor-fields");
    click("editClose");
    answer(QMessageBox::Discard);
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_editor_tests --pictures FOLDER` saves pictures instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowEditorTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--pictures") {
        test.savePictures(arguments.value(2));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_editor_test.moc"
