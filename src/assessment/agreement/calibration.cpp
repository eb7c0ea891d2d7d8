// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/calibration.h"

#include <algorithm>
#include <map>
#include <set>

#include "assessment/messages.h"
#include "geometry/util/assert.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr std::size_t kMostFolds = 10;

/// The marks of one work.
struct MarkSum {
    double sum = 0;
    std::size_t count = 0;
};

/// Sorts works and marks, fits, and compares.
class Calibrator {
public:
    Calibrator(const Rubric& start, std::span<const MeasuredWork> works) : start_(start) {
        for (const MeasuredWork& each : works) {
            const bool isNew = measured_.emplace(each.id, &each).second;
            TACTOOTH_ASSERT(isNew);
        }
    }

    Expected<Calibration> run(std::span<const TeacherMark> marks) {
        if (const auto added = addMarks(marks); !added) return Unexpected{added.error()};
        std::map<std::string, std::size_t> students = chooseWorks();
        calibration_.students = students.size();
        if (examples_.size() < kLeastWorks || students.size() < kLeastStudents) {
            return unexpected(msg::kTooFewMarkedWorks, kLeastWorks, kLeastStudents, examples_.size(), students.size());
        }
        calibration_.fit = fitRubric(start_, examples_);
        for (std::size_t i = 0; i < examples_.size(); ++i) {
            calibration_.works[i].fitted = markOf(calibration_.fit.rubric, *examples_[i].results).value;
        }
        calibration_.folds = std::min(students.size(), kMostFolds);
        std::size_t next = 0;
        for (auto& [name, fold] : students) fold = next++ % calibration_.folds;
        for (std::size_t fold = 0; fold < calibration_.folds; ++fold) holdOut(fold, students);
        compare();
        return std::move(calibration_);
    }

private:
    Expected<void> addMarks(std::span<const TeacherMark> marks) {
        std::map<std::pair<std::string, std::string>, double> sorted;  // by work and teacher
        for (const TeacherMark& each : marks) {
            if (!measured_.contains(each.work)) {
                return unexpected(msg::kMarkedWorkUnknown, quotedWord(each.teacher), quotedWord(each.work));
            }
            const bool isNew = sorted.emplace(std::pair(each.work, each.teacher), each.mark).second;
            TACTOOTH_ASSERT(isNew);
        }
        for (const auto& [names, mark] : sorted) {
            MarkSum& sum = sums_[names.first];
            sum.sum += mark;
            ++sum.count;
            marks_.push_back({names.first, measured_.at(names.first)->student, names.second, mark});
        }
        return {};
    }

    /// Takes the works that have both marks. Returns their students.
    std::map<std::string, std::size_t> chooseWorks() {
        std::map<std::string, std::size_t> students;
        for (const auto& [id, work] : measured_) {
            const auto sum = sums_.find(id);
            const std::optional<double> mark = markOf(start_, work->results).value;
            if (sum == sums_.end()) {
                ++calibration_.notMarked;
            } else if (!mark) {
                ++calibration_.notMeasured;
            } else {
                const double teachers = sum->second.sum / static_cast<double>(sum->second.count);
                calibration_.works.push_back({id, work->student, teachers, sum->second.count, *mark, {}, {}});
                examples_.push_back({&work->results, teachers});
                students.emplace(work->student, 0);
            }
        }
        return students;
    }

    /// Marks the works of one fold by a rubric that was fitted to the others.
    void holdOut(std::size_t fold, const std::map<std::string, std::size_t>& folds) {
        std::vector<FitExample> others;
        for (std::size_t i = 0; i < examples_.size(); ++i) {
            if (folds.at(calibration_.works[i].student) != fold) others.push_back(examples_[i]);
        }
        const RubricFit fit = fitRubric(start_, others);
        for (std::size_t i = 0; i < examples_.size(); ++i) {
            CalibratedWork& work = calibration_.works[i];
            if (folds.at(work.student) == fold) work.heldOut = markOf(fit.rubric, *examples_[i].results).value;
        }
    }

    void compare() {
        std::vector<MarkPair> start, fitted, heldOut;
        std::set<std::string> ids;
        for (const CalibratedWork& each : calibration_.works) {
            ids.insert(each.id);
            start.push_back({each.teachers, each.start});
            if (each.fitted) fitted.push_back({each.teachers, *each.fitted});
            if (each.heldOut) heldOut.push_back({each.teachers, *each.heldOut});
        }
        std::erase_if(marks_, [&](const TeacherMark& each) { return !ids.contains(each.work); });
        calibration_.teachers = teacherAgreement(marks_);
        calibration_.start = markAgreement(start, start_.passMark);
        calibration_.fitted = markAgreement(fitted, start_.passMark);
        calibration_.heldOut = markAgreement(heldOut, start_.passMark);
    }

    const Rubric& start_;
    std::map<std::string, const MeasuredWork*> measured_;
    std::map<std::string, MarkSum> sums_;
    std::vector<TeacherMark> marks_;
    std::vector<FitExample> examples_;  // in the order of Calibration::works
    Calibration calibration_;
};

}  // namespace

Expected<Calibration> calibrate(const Rubric& start, std::span<const MeasuredWork> works,
                                std::span<const TeacherMark> marks) {
    return Calibrator(start, works).run(marks);
}

}  // namespace tactooth
