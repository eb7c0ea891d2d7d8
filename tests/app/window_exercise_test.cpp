// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exercises in the window, what takes long to load, and what of the work another language keeps.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QMenuBar>
#include <QProgressBar>
#include <QToolButton>
#include <fstream>
#include <future>

#include "app/gui/settings/window_setup.h"
#include "app/gui/window/window_owner.h"
#include "app/window_session.h"
#include "geometry/io/stl_writer.h"
#include "support/shapes.h"
#include "support/text_file.h"

namespace tactooth {

class WindowExerciseTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void whatTakesLongToLoadHasABarAndCanBeCancelled();
    void anExerciseCountsWhatIsCutOfItAndBeside();
    void theListIsGroupedAndShowsTheLevels();
    void anExerciseInTheMouthHasASoundToothWithNeighbours();
    void anExerciseOfOnesOwnIsOpenedFromTheMenu();
    void theDepthStopOfAnExerciseEndsWithIt();
    void anExerciseThatCannotBeUsedIsRefusedAndTheToothStays();
    void anotherLanguageKeepsTargetExerciseAndLook();
    void cleanupTestCase();
};

void WindowExerciseTest::initTestCase() {
    openWindowWithSettings();
    waitForTooth();
}

void WindowExerciseTest::cleanupTestCase() { closeWindow(); }

void WindowExerciseTest::whatTakesLongToLoadHasABarAndCanBeCancelled() {
    const std::string before = window_->model().tooth()->name;
    const CutModel* const piece = window_->model().tooth()->piece.get();
    std::promise<void> gate;
    window_->teeth().load(
        [open = std::shared_future<void>(gate.get_future())]() -> Expected<SessionTooth> {
            open.wait();
            return makeSessionTooth(kBuiltinTeeth[1]);
        },
        "Loading");
    auto* bar = window_->findChild<QProgressBar*>("loadProgress");
    auto* cancel = window_->findChild<QToolButton*>("cancelLoading");
    QVERIFY2(!bar->isVisible(), "not for a moment");
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible() && cancel->isVisible(), kPatience);
    QTest::mouseClick(cancel, Qt::LeftButton);
    QVERIFY(!window_->isBusy());
    QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible() && !cancel->isVisible(), kPatience);
    gate.set_value();
    waitForSteps(5);
    QCOMPARE(window_->model().tooth()->name, before);
    QVERIFY(window_->model().tooth()->piece.get() == piece);
}

void WindowExerciseTest::anExerciseCountsWhatIsCutOfItAndBeside() {
    auto* choice = window_->findChild<QComboBox*>("exercise");
    auto* cleared = window_->findChild<QProgressBar*>("cleared");
    const auto* task = window_->findChild<QLabel*>("task");
    const auto* ghost = window_->findChild<QCheckBox*>("ghost");
    const auto fact = [this](const QString& name) {
        for (const QLabel* label : window_->findChildren<QLabel*>())
            if (label->accessibleName() == name) return label->text();
        return QString();
    };
    for (QDockWidget* dock : window_->findChildren<QDockWidget*>())
        if (dock->windowTitle() == "Exercise") dock->raise();
    QVERIFY(!cleared->isEnabled());
    QCOMPARE(fact("Overlap (Dice)"), QString(QChar(0x2013)));
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Down);
    QVERIFY(task->text().contains("1.5 mm deep"));
    QTRY_VERIFY_WITH_TIMEOUT(ghost->isChecked(), kLoadPatience);
    QVERIFY(window_->windowTitle().contains("Pit in the molar"));
    QCOMPARE(QString::fromStdString(window_->model().bur()->name),
             window_->findChild<QComboBox*>("burs")->currentText());
    QTRY_VERIFY_WITH_TIMEOUT(cleared->isEnabled(), kPatience);
    QCOMPARE(cleared->value(), 0);
    QCOMPARE(fact("Time"), "0:00 of 3:00");
    QCOMPARE(task->toolTip(), "Marked by the rubric: Near the ideal preparation");

    window_->model().manipulator().setPressDepth(2);
    key(Qt::Key_C);
    QVERIFY2(waitWithPedal([&] { return gauge("speedGauge") > 300; }), qPrintable(stateOfHand()));
    pressBurOn(middle());
    QVERIFY2(waitWithPedal([&] { return removed() > 0.2; }), qPrintable(stateOfHand()));
    liftBur(middle());
    QTest::keyRelease(&view(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") < 1, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(fact("enamel removed") != "0.00 mm\u00b3", kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(fact("Over-preparation") != "0.00 mm\u00b3" || cleared->value() > 0, kPatience);
    const auto report = folder_ / "report.csv";
    window_->exercise().exportReport(QString::fromStdString(report.string()));
    waitForFiles();
    std::ifstream file(report);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    QVERIFY(text.find("task,\"Pit in the molar\"") != std::string::npos);
    QVERIFY(text.find("first contact,1,times") != std::string::npos);

    QTest::mouseClick(window_->findChild<QToolButton*>("startAgain"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), 0.0, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(fact("Over-preparation"), "0.00 mm\u00b3", kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(fact("Time"), "0:00 of 3:00", kPatience);
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Up);
    QTRY_VERIFY_WITH_TIMEOUT(!cleared->isEnabled(), kPatience);
    QVERIFY(!ghost->isEnabled());
    loadMolar();
}

void WindowExerciseTest::theListIsGroupedAndShowsTheLevels() {
    const auto* choice = window_->findChild<QComboBox*>("exercise");
    QCOMPARE(choice->itemText(0), "Free practice");
    QStringList headings, titles;
    for (int i = 1; i < choice->count(); ++i) {
        const bool isHeading = (choice->model()->flags(choice->model()->index(i, 0)) & Qt::ItemIsEnabled) == 0;
        (isHeading ? headings : titles) << choice->itemText(i);
    }
    QCOMPARE(titles.size(), static_cast<qsizetype>(exercises().size()));
    QCOMPARE(titles.front(), "Pit in the molar (easy)");
    QCOMPARE(headings.front(), "Hand and eye");
    QVERIFY(headings.contains("Class II"));
    headings.removeDuplicates();
    QCOMPARE(headings.size(), static_cast<qsizetype>(ExerciseGroup::Own));  // all groups but one's own, the last
}

void WindowExerciseTest::anExerciseInTheMouthHasASoundToothWithNeighbours() {
    window_->exercise().start(builtinExercise("class-2-36-do"));
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("36 DO"), kLoadPatience);
    QCOMPARE(window_->model().tooth()->mouthTooth, 36);
    QCOMPARE(window_->findChild<QLabel*>("task")->toolTip(), "Marked by the rubric: Class II, four levels");
    QVERIFY(!window_->model().tooth()->around.empty());
    const LayeredTooth& tooth = window_->model().tooth()->piece->tooth();
    bool has37 = false;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        has37 = has37 || layer.name.starts_with("37");
        QVERIFY(!tooth.materials().hasRole(layer.material, MaterialRole::Decay));
    }
    QVERIFY(has37);
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().targetState().target.metrics != nullptr, kLoadPatience);
    loadMolar();
}

void WindowExerciseTest::anExerciseOfOnesOwnIsOpenedFromTheMenu() {
    const auto file = folder_ / "own.toml";
    test::writeText(file,
                    "name = \"Distal pit\"\ntask = \"Deep down.\"\ntooth = 46\nbur = \"245\"\n"
                    "[cavity]\ndepth = 1.2\n[[cavity.strokes]]\nfrom = [2, 0, 0]\n");
    auto* choice = window_->findChild<QComboBox*>("exercise");
    const int before = choice->count();
    QTest::mouseClick(window_->findChild<QToolButton*>("openExercise"), Qt::LeftButton);
    auto* dialog = window_->findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    dialog->selectFile(QString::fromStdString(file.string()));
    QMetaObject::invokeMethod(dialog, "accept");
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("Distal pit"), kLoadPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QCheckBox*>("ghost")->isChecked(), kLoadPatience);
    QCOMPARE(choice->count(), before + 2);  // with the heading of one's own
    QCOMPARE(choice->currentText(), "Distal pit");
    QCOMPARE(window_->findChild<QLabel*>("task")->text(), "Deep down.");
    QTRY_VERIFY_WITH_TIMEOUT(QString::fromStdString(window_->model().bur()->name).contains("245"), kPatience);
    QVERIFY(window_->settings().recent.find("own.toml") != std::string::npos);

    // After a change of the file it still has one entry in the list.
    test::writeText(file,
                    "name = \"Distal pit, deeper\"\ntask = \"Deeper.\"\ntooth = 46\nbur = \"245\"\n"
                    "[cavity]\ndepth = 1.6\n[[cavity.strokes]]\nfrom = [2, 0, 0]\n");
    window_->exercise().open(QString::fromStdString(file.string()));
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("deeper"), kLoadPatience);
    QCOMPARE(choice->count(), before + 2);
    QCOMPARE(choice->currentText(), "Distal pit, deeper");
    loadMolar();
    QTRY_COMPARE_WITH_TIMEOUT(choice->currentIndex(), 0, kPatience);
}

void WindowExerciseTest::theDepthStopOfAnExerciseEndsWithIt() {
    const auto file = folder_ / "stop.toml";
    const auto start = [&](const std::string& name, const char* key) {
        test::writeText(file, "name = \"" + name + "\"\ntask = \"Deep down.\"\ntooth = 46\nbur = \"245\"\n[cavity]\n" +
                                  "depth = 1.2\n" + key + "[[cavity.strokes]]\nfrom = [2, 0, 0]\n");
        window_->exercise().open(QString::fromStdString(file.string()));
        QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains(QString::fromStdString(name)), kLoadPatience);
    };
    auto* stop = window_->findChild<QCheckBox*>("depthStop");
    QVERIFY(!stop->isChecked());
    start("With a stop", "depth_stop = true\n");
    QTRY_VERIFY_WITH_TIMEOUT(stop->isChecked(), kPatience);
    QVERIFY2(!window_->settings().force.depthStop, "the user has not set it");
    start("Without", "");
    QTRY_VERIFY_WITH_TIMEOUT(!stop->isChecked(), kPatience);

    stop->click();  // the user's own
    start("Again with a stop", "depth_stop = true\n");
    QVERIFY(stop->isChecked());
    loadMolar();
    QVERIFY(stop->isChecked() && window_->settings().force.depthStop);

    start("Once more with a stop", "depth_stop = true\n");
    stop->click();  // in the exercise: the user's last word
    QVERIFY(!stop->isChecked() && !window_->settings().force.depthStop);
    loadMolar();
    QVERIFY(!stop->isChecked());
}

void WindowExerciseTest::anExerciseThatCannotBeUsedIsRefusedAndTheToothStays() {
    const QString title = window_->windowTitle();
    const auto file = folder_ / "bad.toml";
    test::writeText(file, "name = \"Bad\"\ntask = \"None.\"\ntooth = 46\nbur = \"none\"\n");
    window_->exercise().open(QString::fromStdString(file.string()));
    const QString sentence = dismissMessage();
    QVERIFY2(sentence.contains("bad.toml, line 4: there is no bur 'none'"), qPrintable(sentence));
    test::writeText(file,
                    "name = \"Bad\"\ntask = \"None.\"\ntooth = \"gone.stl\"\nbur = \"330\"\nideal = \"gone.stl\"\n");
    window_->exercise().open(QString::fromStdString(file.string()));
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    QVERIFY(dismissMessage().contains("gone.stl"));
    QCOMPARE(window_->windowTitle(), title);
    QCOMPARE(window_->findChild<QComboBox*>("exercise")->currentIndex(), 0);
}

void WindowExerciseTest::anotherLanguageKeepsTargetExerciseAndLook() {
    WindowOwner holder(*qApp, *sound_);
    MainWindow* window = &holder.open(window_->settings());
    window->teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    window->show();
    QTRY_VERIFY_WITH_TIMEOUT(!window->isBusy() && window->model().runner() != nullptr, kLoadPatience);
    const Box3 box = window->model().tooth()->box();
    const auto file = folder_ / "kept.stl";
    QVERIFY(writeStl(test::sphere(Vec3(0, 0, box.max().z() - 3), 2, 40, 30), file).has_value());
    window->exercise().openTarget(QString::fromStdString(file.string()));
    const auto find = [&](const char* name) { return holder.window().findChild<QCheckBox*>(name); };
    QTRY_VERIFY_WITH_TIMEOUT(find("coloured")->isChecked(), kLoadPatience);
    auto* legend = window->findChild<QWidget*>("colourLegend");
    QVERIFY(legend->isVisible());
    QVERIFY(window->findChild<ToothView*>("toothView")->rect().contains(legend->geometry()));
    const QImage colours = legend->grab().toImage();
    find("ghost")->click();
    QVERIFY(legend->isVisible() && legend->grab().toImage() != colours);
    find("ghost")->click();
    QVERIFY(!legend->isVisible());
    find("ghost")->click();
    window->findChild<QComboBox*>("section")->setCurrentIndex(2);
    auto* view = window->findChild<ToothView*>("toothView");
    view->setView(StandardView::Lingual);
    const Vec3 eye = view->camera().cameraInWorld.position;
    const auto choose = [&](int language) {
        holder.window().findChild<QMenu*>("language")->actions()[language]->trigger();
    };
    const auto title = [&] { return holder.window().menuBar()->actions().front()->text(); };
    choose(2);
    QTRY_COMPARE_WITH_TIMEOUT(title(), QStringLiteral("ファイル(&F)"), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(find("ghost")->isChecked(), kPatience);
    QVERIFY(!find("coloured")->isChecked() && find("coloured")->isEnabled());
    QCOMPARE(holder.window().findChild<QComboBox*>("section")->currentIndex(), 2);
    const auto* now = holder.window().findChild<ToothView*>("toothView");
    QVERIFY((now->camera().cameraInWorld.position - eye).norm() < 1e-9);

    holder.window().exercise().start(exercises()[0]);
    QTRY_VERIFY_WITH_TIMEOUT(holder.window().windowTitle().startsWith(QStringLiteral("臼歯")), kLoadPatience);
    QTRY_VERIFY_WITH_TIMEOUT(find("ghost")->isChecked(), kLoadPatience);
    choose(1);
    QTRY_COMPARE_WITH_TIMEOUT(title(), "&File", kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(find("ghost")->isChecked(), kPatience);
    QVERIFY(holder.window().findChild<QComboBox*>("exercise")->currentText().startsWith("Pit in the molar"));
    const auto report = folder_ / "kept.csv";
    holder.window().exercise().exportReport(QString::fromStdString(report.string()));
    QTRY_VERIFY_WITH_TIMEOUT(!holder.window().isWriting(), kPatience);
    QVERIFY(test::readText(report).find("task,\"Pit in the molar\"") != std::string::npos);
    choose(0);
    QTRY_COMPARE_WITH_TIMEOUT(holder.window().settings().language, std::string(), kPatience);
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowExerciseTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_exercise_test.moc"
