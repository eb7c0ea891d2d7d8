// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The grid of burs: how it is opened, searched and marked, and how a bur is taken from it.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "app/gui/dialogs/bur_dialog.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "assessment/exercise.h"
#include "geometry/io/stl_writer.h"
#include "instruments/bur_shape.h"

namespace tactooth {

class WindowBursTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Pictures to look at.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void aKeyTheMenuAndTheDrillBarOpenIt();
    void itOpensAtOnceAndThePicturesFollow();
    void picturesAreKeptUntilTheirSizeChanges();
    void eachBurHasAPictureAndATooltipWithItsNumbers();
    void theSearchLeavesWhatIsLikeIt();
    void favouritesAreKept();
    void theBurOfTheExerciseIsMarked();
    void anExerciseAllowsOnlyItsBurs();
    void enterTakesABur();
    void aClickTakesABur();
    void aBurOfAFileIsThereToo();
    void cleanupTestCase();

private:
    [[nodiscard]] BurDialog* dialog() const { return window_->findChild<BurDialog*>(); }
    [[nodiscard]] BurGrid& grid() const { return *dialog()->findChild<BurGrid*>(); }
    [[nodiscard]] QLineEdit& search() const { return *dialog()->findChild<QLineEdit*>("burSearch"); }
    [[nodiscard]] QComboBox& box() const { return *window_->findChild<QComboBox*>("burs"); }
    [[nodiscard]] QListWidgetItem& item(const QString& number) const {
        for (int i = 0; i < grid().count(); ++i) {
            if (grid().item(i)->text() == number && grid().item(i)->flags() != Qt::NoItemFlags) return *grid().item(i);
        }
        qFatal("no such bur");
    }
    void open();
    void leave();
    void expectBur(const char* number);
};

void WindowBursTest::initTestCase() {
    openWindowWithSettings();
    waitForTooth();
}

void WindowBursTest::cleanupTestCase() { closeWindow(); }

void WindowBursTest::open() {
    key(Qt::Key_B, Qt::ControlModifier);
    QVERIFY(dialog() != nullptr);
    QVERIFY(QTest::qWaitForWindowExposed(dialog(), kPatience));
}

void WindowBursTest::leave() {
    QTest::keyClick(dialog(), Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatience);
}

void WindowBursTest::expectBur(const char* number) {
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().bur()->name, findBur(number)->name, kPatience);
    waitForTooth();
    QCOMPARE(box().currentData().toString(), QString(number));
}

void WindowBursTest::aKeyTheMenuAndTheDrillBarOpenIt() {
    open();
    QVERIFY(grid().currentBur() != nullptr);
    QCOMPARE(grid().currentBur()->spec->number, std::string("4"));
    leave();
    window_->findChild<QAction*>("burEntry")->trigger();
    QVERIFY(dialog() != nullptr);
    leave();
    QTest::mouseClick(&box(), Qt::LeftButton);
    QVERIFY(dialog() != nullptr);
    leave();
    QCOMPARE(window_->model().bur()->name, findBur("4")->name);
}

void WindowBursTest::itOpensAtOnceAndThePicturesFollow() {
    MainWindow other(*sound_);  // with no picture drawn yet
    auto* entry = other.findChild<QAction*>("burEntry");
    entry->trigger();
    auto* shown = other.findChild<BurGrid*>();
    QVERIFY(shown != nullptr);
    QVERIFY(shown->isDrawing());  // none was waited for
    QTRY_VERIFY_WITH_TIMEOUT(!shown->isDrawing(), kPatience);
}

void WindowBursTest::picturesAreKeptUntilTheirSizeChanges() {
    BurPictures pictures;
    pictures.setSize({40, 80}, 1);
    QVERIFY(pictures.find("4") == nullptr);
    pictures.draw(*findBur("4"));
    const QPixmap* drawn = pictures.find("4");
    QVERIFY(drawn != nullptr);
    QCOMPARE(drawn->size(), QSize(40, 80));
    pictures.setSize({40, 80}, 1);
    QVERIFY(pictures.find("4") == drawn);
    pictures.setSize({40, 80}, 2);
    QVERIFY(pictures.find("4") == nullptr);
    pictures.draw(*findBur("4"));
    QCOMPARE(pictures.find("4")->size(), QSize(80, 160));
}

void WindowBursTest::eachBurHasAPictureAndATooltipWithItsNumbers() {
    open();
    QTRY_VERIFY_WITH_TIMEOUT(!grid().isDrawing(), kPatience);
    QCOMPARE(grid().shownBurs(), static_cast<int>(burCatalogue().size()));
    for (const BurSpec& spec : burCatalogue()) {
        const QListWidgetItem& bur = item(QString::fromStdString(spec.number));
        const QString tip = bur.toolTip();
        QVERIFY2(tip.contains(QString::fromStdString(isoNumber(spec))), qPrintable(tip));
        QVERIFY2(tip.contains(QString("Diameter %1 mm").arg(spec.headDiameter, 0, 'f', 1)), qPrintable(tip));
        QVERIFY2(tip.contains("Head length"), qPrintable(tip));
        QVERIFY(bur.data(Qt::AccessibleTextRole).toString().contains(QString::fromStdString(spec.name)));
    }
    const auto pictureOf = [this](const QString& number) {
        grid().scrollToItem(&item(number), QAbstractItemView::PositionAtCenter);
        return grid().viewport()->grab(grid().visualItemRect(&item(number))).toImage();
    };
    QVERIFY(pictureOf("2") != pictureOf("909-040"));
    leave();
}

void WindowBursTest::theSearchLeavesWhatIsLikeIt() {
    open();
    QTest::keyClicks(&grid(), "pear");
    QCOMPARE(search().text(), QString("pear"));
    int pears = 0;
    for (const BurSpec& spec : burCatalogue()) pears += spec.name.find("ear ") != std::string::npos ? 1 : 0;
    QCOMPARE(grid().shownBurs(), pears);
    QVERIFY(grid().currentBur()->spec->kind == BurKind::Pear);
    search().setText("no such bur");
    QCOMPARE(grid().shownBurs(), 0);
    QVERIFY(grid().currentBur() == nullptr);
    QVERIFY(!dialog()->findChild<QLabel*>("burFacts")->text().isEmpty());
    QTest::keyClick(&search(), Qt::Key_Return);
    QVERIFY(dialog()->isVisible());
    search().clear();
    QCOMPARE(grid().shownBurs(), static_cast<int>(burCatalogue().size()));
    leave();
}

void WindowBursTest::favouritesAreKept() {
    open();
    grid().setCurrentItem(&item("245"));
    QTest::keyClick(&grid(), Qt::Key_Space);
    QVERIFY(dialog()->findChild<QPushButton*>("favourite")->isChecked());
    grid().setCurrentItem(&item("58"));
    grid().scrollToItem(&item("58"));
    QTest::mouseClick(grid().viewport(), Qt::LeftButton, {}, grid().starOf(item("58")).center());
    QVERIFY(dialog() != nullptr && dialog()->isVisible());  // the star takes no bur
    QVERIFY(item("58").toolTip().contains("Favourite"));
    auto* only = dialog()->findChild<QCheckBox*>("favouritesOnly");
    only->setChecked(true);
    QCOMPARE(grid().shownBurs(), 2);
    dialog()->findChild<QPushButton*>("favourite")->click();
    QCOMPARE(grid().shownBurs(), 1);
    only->setChecked(false);
    leave();
    QCOMPARE(window_->settings().favouriteBurs, std::string("245"));
    MainWindow other(*sound_);
    other.apply(window_->settings());
    QCOMPARE(other.settings().favouriteBurs, std::string("245"));
    open();
    QVERIFY(item("245").toolTip().contains("Favourite"));
    QVERIFY(!item("58").toolTip().contains("Favourite"));
    leave();
}

void WindowBursTest::theBurOfTheExerciseIsMarked() {
    open();
    for (const BurSpec& spec : burCatalogue()) {
        QVERIFY(!item(QString::fromStdString(spec.number)).toolTip().contains("exercise"));
    }
    leave();
    window_->exercise().start(exercises().front());
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() != nullptr, kLoadPatience);
    waitForTooth();
    const std::string wanted = std::get<std::string>(exercises().front()->bur);
    open();
    QVERIFY(item(QString::fromStdString(wanted)).toolTip().contains("Used in this exercise"));
    QVERIFY(!item("58").toolTip().contains("exercise"));
    leave();
    loadMolar();
}

/// By no way: the grid, the keys of the box, the menu of files, or the settings.
void WindowBursTest::anExerciseAllowsOnlyItsBurs() {
    Exercise strict = *builtinExercise("class-1-46");
    strict.onlyTheseBurs = true;
    strict.otherBurs = {"330"};
    window_->exercise().start(std::make_shared<const Exercise>(strict));
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() != nullptr, kLoadPatience);
    waitForTooth();
    QCOMPARE(box().currentData().toString(), QString("245"));
    QVERIFY(!window_->findChild<QAction*>("openBur")->isEnabled());
    open();
    for (const BurSpec& spec : burCatalogue()) {
        const QListWidgetItem& bur = item(QString::fromStdString(spec.number));
        const bool isAllowed = spec.number == "245" || spec.number == "330";
        QCOMPARE(bur.flags().testFlag(Qt::ItemIsEnabled), isAllowed);
        QCOMPARE(bur.toolTip().contains("This exercise allows other burs only"), !isAllowed);
    }
    grid().scrollToItem(&item("57"), QAbstractItemView::PositionAtCenter);
    QTest::mouseClick(grid().viewport(), Qt::LeftButton, {}, grid().visualItemRect(&item("57")).center());
    QVERIFY(dialog() != nullptr && dialog()->isVisible());
    QTest::keyClicks(&grid(), "57");
    QTest::keyClick(&search(), Qt::Key_Return);
    QVERIFY(dialog() != nullptr && dialog()->isVisible());
    search().setText("556");  // alone
    QVERIFY(grid().currentBur() == nullptr);
    QCOMPARE(dialog()->findChild<QLabel*>("burFacts")->text(), QString("This exercise allows other burs only"));
    leave();
    WindowSettings settings = window_->settings();
    settings.bur = "57";
    window_->change(settings);
    QCOMPARE(box().currentData().toString(), QString("245"));
    box().setFocus();
    QTest::keyClick(&box(), Qt::Key_Up);  // 330 stands before it, with others between
    expectBur("330");
    open();
    grid().setCurrentItem(&item("245"));
    QTest::keyClick(&grid(), Qt::Key_Return);
    expectBur("245");

    window_->exercise().start(nullptr);  // free practice allows all
    QVERIFY(window_->findChild<QAction*>("openBur")->isEnabled());
    open();
    QVERIFY(item("57").flags().testFlag(Qt::ItemIsEnabled));
    QVERIFY(!item("57").toolTip().contains("allows"));
    grid().setCurrentItem(&item("57"));
    QTest::keyClick(&grid(), Qt::Key_Return);
    expectBur("57");
    loadMolar();
}

void WindowBursTest::enterTakesABur() {
    open();
    QTest::keyClicks(&grid(), "856-018");
    QTest::keyClick(&search(), Qt::Key_Return);
    expectBur("856-018");
    open();
    grid().setCurrentItem(&item("2"));
    grid().setFocus();
    QTest::keyClick(&grid(), Qt::Key_Right);
    QTest::keyClick(&grid(), Qt::Key_Return);
    expectBur("3");
}

void WindowBursTest::aClickTakesABur() {
    open();
    grid().scrollToItem(&item("330"), QAbstractItemView::PositionAtCenter);
    QTest::mouseClick(grid().viewport(), Qt::LeftButton, {}, grid().visualItemRect(&item("330")).center());
    expectBur("330");
}

void WindowBursTest::aBurOfAFileIsThereToo() {
    const auto file = folder_ / "own-bur.stl";
    QVERIFY(writeStl(makeBur(*findBur("6")).surface, file).has_value());
    window_->teeth().openBur(QString::fromStdString(file.string()));
    QTRY_VERIFY_WITH_TIMEOUT(box().currentText().contains("own-bur"), kLoadPatience);
    waitForTooth();
    open();
    QCOMPARE(grid().shownBurs(), static_cast<int>(burCatalogue().size()) + 1);
    QVERIFY(grid().currentBur() != nullptr && !grid().currentBur()->spec);
    QVERIFY(!dialog()->findChild<QPushButton*>("favourite")->isEnabled());
    leave();
}

void WindowBursTest::savePictures(const QString& folder) {
    initTestCase();
    WindowSettings settings = window_->settings();
    settings.favouriteBurs = "245, 4, 801-014";
    window_->apply(settings);
    window_->exercise().start(exercises().front());
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() != nullptr, kLoadPatience);
    waitForTooth();
    for (const bool dark : {false, true}) {
        applyColours(dark);
        open();
        QTRY_VERIFY_WITH_TIMEOUT(!grid().isDrawing(), kPatience);
        dialog()->grab().save(folder + (dark ? "/bur-grid-dark.png" : "/bur-grid.png"));
        grid().scrollToBottom();
        dialog()->grab().save(folder + (dark ? "/bur-grid-end-dark.png" : "/bur-grid-end.png"));
        leave();
    }
    applyColours(false);
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_burs_tests --pictures FOLDER` saves pictures instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowBursTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--pictures") {
        test.savePictures(arguments.value(2));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_burs_test.moc"
