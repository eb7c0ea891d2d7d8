// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/write_case.h"

#include "geometry/atomic_file.h"
#include "geometry/file_bytes.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

Unexpected cannotMake(const fs::path& folder, const std::error_code& why) {
    return unexpected(shownName(folder) + ": the folder cannot be made (" + why.message() + ").");
}

/// `shownAs`: the folder's name in messages.
Expected<void> writeFiles(const std::vector<CaseFile>& files, const fs::path& folder, const fs::path& shownAs) {
    for (const CaseFile& file : files) {
        const fs::path path = folder / fs::path(file.entry), shown = shownAs / fs::path(file.entry);
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (error) return cannotMake(shown.parent_path(), error);
        if (auto written = writeFile(path, file.bytes); !written) {
            std::string why = written.error().message;
            if (const std::string name = shownName(path); why.starts_with(name)) {
                why.replace(0, name.size(), shownName(shown));
            }
            return unexpected(std::move(why));
        }
    }
    return {};
}

/// Into a folder that is there and stays the same one: somebody may stand in it, or it may be a disk of its own.
Expected<void> fillFolder(const std::vector<CaseFile>& files, const fs::path& folder) {
    auto done = writeFiles(files, folder, folder);
    if (done) return done;
    std::error_code ignored;
    for (const fs::path& left : fs::directory_iterator(folder, ignored)) fs::remove_all(left, ignored);
    return done;
}

/// A folder that appears under its name when it is complete.
Expected<void> writeNewFolder(const std::vector<CaseFile>& files, const fs::path& to) {
    std::error_code error;
    fs::path folder = fs::absolute(to, error);
    if (!folder.has_filename()) folder = folder.parent_path();  // "case/"
    fs::create_directories(folder.parent_path(), error);
    const fs::path unfinished = temporaryNameBeside(folder);
    if (error || !fs::create_directory(unfinished, error)) return cannotMake(to, error);
    auto done = writeFiles(files, unfinished, to);
    if (done) fs::rename(unfinished, folder, error);
    if (done && !error) return {};
    std::error_code ignored;
    fs::remove_all(unfinished, ignored);
    if (done) return cannotMake(to, error);
    return done;
}

}  // namespace

Expected<void> checkCaseTarget(const fs::path& to) {
    std::error_code error;
    if (to.extension() == kCaseEnding || !fs::exists(to, error)) return {};
    if (fs::is_directory(to, error) && fs::is_empty(to, error)) return {};
    return unexpected(shownName(to) + ": there is something already; give a new folder, or a name that ends in " +
                      std::string(kCaseEnding) + ".");
}

Expected<void> writeCase(const std::vector<CaseFile>& files, const fs::path& to) {
    if (to.extension() == kCaseEnding) {
        const auto bytes = packedCase(files);
        if (!bytes) return Unexpected{bytes.error()};
        return writeFile(to, *bytes);
    }
    if (auto done = checkCaseTarget(to); !done) return done;
    std::error_code error;
    return fs::exists(to, error) ? fillFolder(files, to) : writeNewFolder(files, to);
}

}  // namespace tactooth
