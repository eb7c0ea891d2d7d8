// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/class_works.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "app/cli/cases/messages.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/lower_case.h"
#include "geometry/util/messages.h"
#include "geometry/util/natural_order.h"
#include "geometry/util/system_reason.h"

namespace tactooth {
namespace {

constexpr std::array kExtensions = {".ttsession", ".tactooth", ".stl", ".obj", ".ply"};

/// What a folder has that is not hidden.
struct FolderContents {
    std::vector<std::filesystem::path> works, folders;
};

Expected<FolderContents> contentsOf(const std::filesystem::path& folder) {
    FolderContents contents;
    std::error_code fault;
    for (std::filesystem::directory_iterator each(folder, fault), end; !fault && each != end; each.increment(fault)) {
        if (each->path().filename().native().starts_with('.')) continue;
        const std::string extension = toLowerCase(each->path().extension().native());
        if (each->is_directory(fault)) {
            contents.folders.push_back(each->path());
        } else if (std::ranges::find(kExtensions, extension) != kExtensions.end()) {
            contents.works.push_back(each->path());
        }
    }
    if (fault) return unexpected(msg::kFolderNotRead, displayName(folder), systemReason(fault));
    for (auto* paths : {&contents.works, &contents.folders}) {
        std::ranges::sort(*paths, [](const auto& a, const auto& b) {
            return isNaturallyLess(a.filename().native(), b.filename().native());
        });
    }
    return contents;
}

/// A folder for each work: its name without the extension, or with it where two works, or a work and a page or a
/// student's folder (`others`), have the same name.
std::vector<ClassWork> withFolders(const std::vector<std::filesystem::path>& works, const std::string& student,
                                   const std::vector<std::filesystem::path>& others) {
    std::multiset<std::string> stems(kClassFiles.begin(), kClassFiles.end());
    stems.insert(kStudentPage);
    for (const auto& other : others) stems.insert(toLowerCase(other.filename().native()));
    for (const auto& work : works) stems.insert(toLowerCase(work.stem().native()));
    std::vector<ClassWork> result;
    for (const auto& work : works) {
        const bool isOnly = stems.count(toLowerCase(work.stem().native())) == 1;
        result.push_back({work, student, isOnly ? work.stem().native() : work.filename().native()});
    }
    return result;
}

}  // namespace

Expected<std::vector<std::filesystem::path>> worksIn(const std::filesystem::path& folder) {
    Expected<FolderContents> contents = contentsOf(folder);
    if (!contents) return Unexpected{contents.error()};
    if (contents->works.empty()) return unexpected(msg::kNoWorksInFolder, displayName(folder));
    return std::move(contents->works);
}

Expected<std::vector<ClassWork>> worksOfClass(const std::filesystem::path& folder) {
    const Expected<FolderContents> contents = contentsOf(folder);
    if (!contents) return Unexpected{contents.error()};
    std::vector<std::filesystem::path> students;
    std::vector<ClassWork> trials;
    for (const std::filesystem::path& student : contents->folders) {
        const Expected<FolderContents> inside = contentsOf(student);
        if (!inside) return Unexpected{inside.error()};
        if (inside->works.empty()) continue;
        students.push_back(student);
        for (ClassWork& each : withFolders(inside->works, student.filename().native(), {}))
            trials.push_back(std::move(each));
    }
    std::vector<ClassWork> works = withFolders(contents->works, {}, students);
    works.insert(works.end(), std::make_move_iterator(trials.begin()), std::make_move_iterator(trials.end()));
    if (works.empty()) return unexpected(msg::kNoWorksInFolder, displayName(folder));
    return works;
}

}  // namespace tactooth
