// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/teacher_marks.h"

#include <utility>

#include "assessment/agreement/mark_agreement.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// Marks of each work by the number of the teacher, works and teachers in the order of their names.
class MarkTable {
public:
    explicit MarkTable(std::span<const TeacherMark> marks) {
        std::map<std::string, std::size_t> numbers;
        for (const TeacherMark& each : marks) numbers.emplace(each.teacher, 0);
        for (auto& [name, number] : numbers) number = teachers_++;
        std::map<std::string, std::map<std::size_t, double>> works;
        for (const TeacherMark& each : marks) {
            const bool isNew = works[each.work].emplace(numbers.at(each.teacher), each.mark).second;
            TACTOOTH_ASSERT(isNew);
        }
        for (auto& [name, row] : works) rows_.push_back(std::move(row));
    }

    [[nodiscard]] std::size_t teachers() const { return teachers_; }
    [[nodiscard]] std::size_t works() const { return rows_.size(); }

    /// The rows that are complete, for intraclassCorrelation.
    [[nodiscard]] std::vector<double> complete() const {
        std::vector<double> ratings;
        for (const auto& row : rows_) {
            if (row.size() != teachers_) continue;
            for (const auto& [teacher, mark] : row) ratings.push_back(mark);
        }
        return ratings;
    }

    /// The levels of each two teachers in a work: which two, and what they gave.
    struct Met {
        std::size_t pair;
        LevelPair levels;
    };
    [[nodiscard]] std::vector<std::vector<Met>> meetings() const {
        std::vector<std::vector<Met>> all(rows_.size());
        for (std::size_t work = 0; work < rows_.size(); ++work) {
            for (auto a = rows_[work].begin(); a != rows_[work].end(); ++a) {
                for (auto b = std::next(a); b != rows_[work].end(); ++b) {
                    all[work].push_back({a->first * teachers_ + b->first, {levelOf(a->second), levelOf(b->second)}});
                }
            }
        }
        return all;
    }

private:
    static std::size_t levelOf(double mark) { return static_cast<std::size_t>(levelOfMark(mark)); }

    std::size_t teachers_ = 0;
    std::vector<std::map<std::size_t, double>> rows_;
};

/// Light's kappa of some of the works.
std::optional<double> meanKappa(const std::vector<std::vector<MarkTable::Met>>& meetings, std::size_t teachers,
                                std::span<const std::size_t> chosen) {
    std::vector<ConfusionMatrix> matrices(teachers * teachers, ConfusionMatrix(kMarkLevels));
    for (const std::size_t work : chosen) {
        for (const MarkTable::Met& each : meetings[work]) matrices[each.pair].add(each.levels);
    }
    double sum = 0, pairs = 0;
    for (const ConfusionMatrix& matrix : matrices) {
        const std::optional<double> kappa = weightedKappa(matrix, KappaWeights::Quadratic);
        if (!kappa) continue;
        sum += *kappa;
        ++pairs;
    }
    return pairs > 0 ? std::optional(sum / pairs) : std::nullopt;
}

}  // namespace

std::map<std::string, std::string> studentsOf(std::span<const TeacherMark> marks) {
    std::map<std::string, std::string> students;
    for (const TeacherMark& each : marks) students.emplace(each.work, each.student);
    return students;
}

TeacherAgreement teacherAgreement(std::span<const TeacherMark> marks) {
    const MarkTable table(marks);
    TeacherAgreement agreement;
    agreement.teachers = table.teachers();
    agreement.works = table.works();
    if (agreement.teachers == 0) return agreement;
    const std::vector<double> complete = table.complete();
    agreement.commonWorks = complete.size() / agreement.teachers;
    agreement.icc = intraclassCorrelation(complete, agreement.teachers);
    const auto meetings = table.meetings();
    std::vector<std::size_t> all(meetings.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const auto statistic = [&](std::span<const std::size_t> chosen) {
        return meanKappa(meetings, agreement.teachers, chosen);
    };
    if (const auto value = statistic(all)) agreement.kappa = Kappa{*value, bootstrapInterval(all.size(), statistic)};
    return agreement;
}

}  // namespace tactooth
