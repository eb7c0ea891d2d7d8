// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/util/expected.h"

namespace tactooth {

/// The recordings, saved teeth and surfaces in a folder, by name; hidden files and other files are left out. Fails with
/// one sentence if the folder cannot be read or has none.
[[nodiscard]] Expected<std::vector<std::filesystem::path>> worksIn(const std::filesystem::path& folder);

/// The table of a class, and the page of a student: no folder of a report has one of these names.
inline constexpr std::array kClassFiles = {"class.html", "class.csv"};
inline constexpr const char* kStudentPage = "student.html";

/// A work of a class.
struct ClassWork {
    std::filesystem::path file;
    std::string student;  ///< name of the folder with the student's works; empty: this is the only one
    std::string folder;   ///< name of the folder for its report, in the folder of the class or of the student
};

/// The works in a folder, each of another student, then those in each folder inside it, each of which has the trials of
/// one student. In the order of their names, numbers in them by value: "trial-2" before "trial-10". Fails with one
/// sentence if a folder cannot be read, or if there is no work.
[[nodiscard]] Expected<std::vector<ClassWork>> worksOfClass(const std::filesystem::path& folder);

}  // namespace tactooth
