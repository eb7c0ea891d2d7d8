// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "assessment/agreement/teacher_marks.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Reads the marks of a school's teachers: a CSV file (session/io/csv_table.h) with the columns work, student, teacher
/// and mark (0 to 100), in any order, and a row for each mark. Other columns are ignored. Names are compared in the
/// composed form of Unicode, in which a Mac and a PC agree.
///
/// Fails with one sentence with file and line: what the CSV reader refuses, a name that is empty or not UTF-8, a mark
/// outside 0 to 100, a second mark of a teacher for a work, a work of two students, more than 50 teachers or 100,000
/// marks.
[[nodiscard]] Expected<std::vector<TeacherMark>> readMarks(const std::filesystem::path& file);

/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] Expected<std::vector<TeacherMark>> parseMarks(std::string_view text, std::string_view name);

}  // namespace tactooth
