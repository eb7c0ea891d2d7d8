// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/calibration.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "assessment/agreement/made_up_class.h"
#include "assessment/rubric/rubric_file.h"

namespace tactooth {
namespace {

using namespace test;
using ::testing::HasSubstr;

const std::array<double, 4> kTrueWeights = {45, 30, 20, 5};
const Rubric& trueRubric() {
    static const Rubric rubric = madeUpRubric(kTrueWeights, 1.3);
    return rubric;
}
const Rubric& startRubric() {
    static const Rubric rubric = madeUpRubric({25, 25, 25, 25});
    return rubric;
}

Calibration calibrationOf(const std::vector<MeasuredWork>& works, const std::vector<TeacherMark>& marks) {
    auto calibration = calibrate(startRubric(), works, marks);
    EXPECT_TRUE(calibration) << calibration.error().message();
    return std::move(*calibration);
}

TEST(Calibration, FindsTheRubricOfTheTeachers) {
    const auto works = madeUpWorks(40, 6, 1);
    const Calibration found = calibrationOf(works, marksBy(trueRubric(), works, 3, 5, 2));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found.fit.criteria[i].weight, kTrueWeights[i], 6) << i;
    EXPECT_NEAR(found.fit.criteria[0].widening, 1.3, 0.16);
    EXPECT_EQ(found.works.size(), 240U);
    EXPECT_EQ(found.students, 40U);
    EXPECT_EQ(found.folds, 10U);
    EXPECT_TRUE(found.helps());
    EXPECT_LT(*found.heldOut.rms, 0.6 * *found.start.rms);
    EXPECT_LT(*found.heldOut.rms, 4.5);  // the mean of three teachers errs by 2.9 itself
    EXPECT_LE(*found.fitted.rms, *found.heldOut.rms + 0.1);
    EXPECT_GT(*found.heldOut.icc->agreement, *found.start.icc->agreement);
    EXPECT_GT(found.heldOut.quadraticKappa->value, found.start.quadraticKappa->value);
    EXPECT_EQ(found.teachers.teachers, 3U);
    EXPECT_EQ(found.teachers.commonWorks, 240U);
    EXPECT_GT(*found.teachers.icc->agreement, 0.75);
    EXPECT_GT(found.teachers.kappa->value, 0.6);
}

TEST(Calibration, FindsNoAgreementWithTeachersWhoGuess) {
    const auto works = madeUpWorks(20, 8, 3);
    SeededRandom random(4);
    std::vector<TeacherMark> marks;
    for (const MeasuredWork& work : works) {
        for (const char* teacher : {"A", "B", "C"})
            marks.push_back({work.id, work.student, teacher, 100 * random.share()});
    }
    const Calibration found = calibrationOf(works, marks);
    EXPECT_LT(*found.teachers.icc->agreement, 0.2);
    EXPECT_LT(found.teachers.icc->agreementInterval->low, 0.05);
    EXPECT_LT(found.teachers.kappa->value, 0.2);
    EXPECT_LT(*found.heldOut.icc->agreement, 0.2);
    EXPECT_LT(found.heldOut.icc->agreementInterval->low, 0);
    EXPECT_NEAR(*found.heldOut.areaUnderCurve, 0.5, 0.2);
}

TEST(Calibration, MarksAWorkByARubricThatHasNotSeenItsStudent) {
    const auto works = madeUpWorks(7, 4, 5);
    auto marks = marksBy(trueRubric(), works, 2, 5, 6);
    const Calibration before = calibrationOf(works, marks);
    for (TeacherMark& each : marks) {
        if (each.student == "student 3") each.mark = 100 - each.mark;
    }
    const Calibration after = calibrationOf(works, marks);
    EXPECT_EQ(before.folds, 7U);
    int same = 0, changed = 0;
    for (std::size_t i = 0; i < works.size(); ++i) {
        if (before.works[i].student == "student 3") {
            EXPECT_EQ(before.works[i].heldOut, after.works[i].heldOut);
            ++same;
        } else {
            changed += before.works[i].heldOut != after.works[i].heldOut ? 1 : 0;
        }
    }
    EXPECT_EQ(same, 4);
    EXPECT_GT(changed, 12);
}

TEST(Calibration, DoesNotDependOnTheOrder) {
    auto works = madeUpWorks(6, 4, 7);
    auto marks = marksBy(trueRubric(), works, 3, 6, 8);
    const Calibration before = calibrationOf(works, marks);
    SeededRandom random(9);
    for (std::size_t i = works.size(); i > 1; --i) std::swap(works[i - 1], works[random.below(i)]);
    for (std::size_t i = marks.size(); i > 1; --i) std::swap(marks[i - 1], marks[random.below(i)]);
    const Calibration after = calibrationOf(works, marks);
    EXPECT_EQ(rubricText(before.fit.rubric), rubricText(after.fit.rubric));
    for (std::size_t i = 0; i < works.size(); ++i) {
        EXPECT_EQ(before.works[i].id, after.works[i].id);
        EXPECT_EQ(before.works[i].teachers, after.works[i].teachers);
        EXPECT_EQ(before.works[i].heldOut, after.works[i].heldOut);
    }
    EXPECT_EQ(before.heldOut.rms, after.heldOut.rms);
    EXPECT_EQ(before.heldOut.icc->agreementInterval, after.heldOut.icc->agreementInterval);
    EXPECT_EQ(before.heldOut.quadraticKappa->interval, after.heldOut.quadraticKappa->interval);
    EXPECT_EQ(before.teachers.kappa->interval, after.teachers.kappa->interval);
}

TEST(Calibration, TakesMarksThatAreMissing) {
    const auto works = madeUpWorks(6, 4, 10);
    auto marks = marksBy(trueRubric(), works, 3, 4, 11);
    // Of the first work no mark, of the second that of one teacher.
    std::erase_if(marks, [&](const TeacherMark& each) {
        return each.work == works[0].id || (each.work == works[1].id && each.teacher != "teacher 2");
    });
    const Calibration found = calibrationOf(works, marks);
    EXPECT_EQ(found.works.size(), 23U);
    EXPECT_EQ(found.notMarked, 1U);
    EXPECT_EQ(found.works[0].id, works[1].id);
    EXPECT_EQ(found.works[0].teacherCount, 1U);
    EXPECT_EQ(found.teachers.works, 23U);
    EXPECT_EQ(found.teachers.commonWorks, 22U);
    EXPECT_EQ(found.teachers.icc->works, 22U);
}

TEST(Calibration, LeavesOutAWorkOnWhichNothingCanBeMeasured) {
    auto works = madeUpWorks(6, 4, 12);
    const auto marks = marksBy(trueRubric(), works, 1, 4, 13);
    for (MetricResult& each : works[5].results) each.measured = {};
    const Calibration found = calibrationOf(works, marks);
    EXPECT_EQ(found.notMeasured, 1U);
    EXPECT_EQ(found.works.size(), 23U);
    EXPECT_FALSE(found.teachers.icc || found.teachers.kappa);  // there is one teacher only
}

TEST(Calibration, GivesARubricThatCanBeReadBack) {
    const auto works = madeUpWorks(8, 3, 14);
    const Calibration found = calibrationOf(works, marksBy(trueRubric(), works, 2, 6, 15));
    const std::string text = rubricText(found.fit.rubric);
    const auto read = parseRubric(text, "fitted.toml");
    ASSERT_TRUE(read) << read.error().message();
    for (std::size_t i = 0; i < found.works.size(); ++i) {
        const auto work = std::ranges::find(works, found.works[i].id, &MeasuredWork::id);
        EXPECT_EQ(markOf(*read, work->results).value, found.works[i].fitted);
    }
}

TEST(Calibration, RefusesTooFewWorksOrStudents) {
    const auto few = madeUpWorks(9, 1, 16), fewStudents = madeUpWorks(4, 5, 17);
    const auto nine = calibrate(startRubric(), few, marksBy(trueRubric(), few, 2, 4, 1));
    ASSERT_FALSE(nine);
    EXPECT_EQ(
        nine.error().message(),
        "a rubric is fitted to at least 10 measured and marked works of 5 students, but these are 9 of 9; add more.");
    EXPECT_THAT(nine.error().in(Language::Japanese), HasSubstr("10 個以上"));
    const auto four = calibrate(startRubric(), fewStudents, marksBy(trueRubric(), fewStudents, 2, 4, 1));
    ASSERT_FALSE(four);
    EXPECT_THAT(four.error().message(), HasSubstr("but these are 20 of 4"));
    EXPECT_FALSE(calibrate(startRubric(), {}, {}));
    const auto enough = madeUpWorks(5, 2, 18);
    EXPECT_TRUE(calibrate(startRubric(), enough, marksBy(trueRubric(), enough, 1, 4, 1)));
}

TEST(Calibration, RefusesAMarkOfAnUnknownWork) {
    const auto works = madeUpWorks(6, 3, 19);
    auto marks = marksBy(trueRubric(), works, 1, 4, 20);
    marks.push_back({"lost", "student 1", "teacher 0", 50});
    const auto found = calibrate(startRubric(), works, marks);
    ASSERT_FALSE(found);
    EXPECT_EQ(
        found.error().message(),
        "there is a mark of 'teacher 0' for the work 'lost', but no such work; correct its name, or add its file.");
}

TEST(Calibration, SurvivesMarksThatAreAllEqual) {
    const auto works = madeUpWorks(6, 3, 21);
    auto marks = marksBy(trueRubric(), works, 2, 4, 22);
    for (TeacherMark& each : marks) each.mark = 80;
    const Calibration found = calibrationOf(works, marks);
    EXPECT_FALSE(found.teachers.icc->agreement);
    EXPECT_FALSE(found.teachers.kappa);
    EXPECT_FALSE(found.heldOut.failures.sensitivity);
    EXPECT_FALSE(found.heldOut.areaUnderCurve);
    ASSERT_TRUE(found.heldOut.rms);
    EXPECT_TRUE(std::isfinite(*found.heldOut.rms));
}

}  // namespace
}  // namespace tactooth
