// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/marks_file.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "assessment/messages.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"
#include "session/io/csv_table.h"
#include "session/io/unicode_text.h"

namespace tactooth {
namespace {

constexpr std::array<std::string_view, 1> kMarkColumn = {"mark"};
constexpr std::array<std::string_view, 3> kNameColumns = {"work", "student", "teacher"};
constexpr double kBestMark = 100;
// Each two teachers are compared in each of 2,000 draws of the works; this many take some seconds.
constexpr std::size_t kMostTeachers = 50;
constexpr std::size_t kMostMarks = 100'000;

/// Checks the rows of a table one after the other.
class MarksReader {
public:
    explicit MarksReader(const CsvTable& table) : table_(table) {}

    Expected<std::vector<TeacherMark>> read() {
        for (std::size_t row = 0; row < table_.rows(); ++row) {
            const TeacherMark mark{nameAt(row, 0), nameAt(row, 1), nameAt(row, 2), table_.at(row, 0)};
            if (const auto fault = faultIn(row, mark)) {
                return unexpected(msg::kNamedSentence, table_.where(row), *fault);
            }
            marks_.push_back(mark);
        }
        return std::move(marks_);
    }

private:
    [[nodiscard]] std::string nameAt(std::size_t row, std::size_t column) const {
        return composed(table_.wordAt(row, column));
    }

    std::optional<Message> faultIn(std::size_t row, const TeacherMark& mark) {
        if (row >= kMostMarks) return Message(msg::kTooManyMarks, kMostMarks);
        for (std::size_t i = 0; i < kNameColumns.size(); ++i) {
            const std::string& name = table_.wordAt(row, i);
            if (name.empty()) return Message(msg::kMarksNameEmpty, kNameColumns[i]);
            if (validUtf8(name) != name) return Message(msg::kMarksNameNotUtf8, kNameColumns[i], quotedWord(name));
        }
        if (mark.mark < 0 || mark.mark > kBestMark) return Message(msg::kMarkOutOfRange, numberText(mark.mark));
        const auto [given, isNew] = rows_.emplace(std::pair(mark.work, mark.teacher), row);
        if (!isNew) {
            return Message(msg::kMarkTwice, quotedWord(mark.teacher), quotedWord(mark.work),
                           table_.where(given->second));
        }
        const auto& [student, first] = students_.emplace(mark.work, std::pair(mark.student, row)).first->second;
        if (student != mark.student) {
            return Message(msg::kWorkOfTwoStudents, quotedWord(mark.work), quotedWord(mark.student),
                           quotedWord(student), table_.where(first));
        }
        teachers_.insert(mark.teacher);
        if (teachers_.size() > kMostTeachers) return Message(msg::kTooManyTeachers, kMostTeachers);
        return std::nullopt;
    }

    const CsvTable& table_;
    std::vector<TeacherMark> marks_;
    std::map<std::pair<std::string, std::string>, std::size_t> rows_;      // by work and teacher
    std::map<std::string, std::pair<std::string, std::size_t>> students_;  // with the row that says so
    std::set<std::string> teachers_;
};

Expected<std::vector<TeacherMark>> marksOf(const Expected<CsvTable>& table) {
    if (!table) return Unexpected{table.error()};
    return MarksReader(*table).read();
}

}  // namespace

Expected<std::vector<TeacherMark>> readMarks(const std::filesystem::path& file) {
    return marksOf(readCsv(file, kMarkColumn, kNameColumns));
}

Expected<std::vector<TeacherMark>> parseMarks(std::string_view text, std::string_view name) {
    return marksOf(parseCsv(text, name, kMarkColumn, kNameColumns));
}

}  // namespace tactooth
