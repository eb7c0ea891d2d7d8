// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/write_case.h"

#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/staging_folder.h"
#include "geometry/files/temporary_file.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"
#include "session/cases/messages.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

Unexpected cannotMake(const fs::path& folder, const Message& why) {
    return unexpected(msg::kFolderNotMade, displayName(folder), why);
}

/// `shownAs`: the folder's name in messages.
Expected<void> writeFiles(const std::vector<CaseFile>& files, const fs::path& folder, const fs::path& shownAs) {
    for (const CaseFile& file : files) {
        const fs::path path = folder / fs::path(file.entry), shown = shownAs / fs::path(file.entry);
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (error) return cannotMake(shown.parent_path(), systemReason(error));
        if (auto written = writeFile(path, file.bytes); !written) {
            Error refused = written.error();
            refused.replaceFirst(displayName(shown));  // the folder has another name while it is made
            return Unexpected{std::move(refused)};
        }
    }
    return {};
}

/// Writes into an existing folder, which stays the same: it may be a mount point or a working directory.
Expected<void> fillFolder(const std::vector<CaseFile>& files, const fs::path& folder) {
    auto unfinished = StagingFolder::make(folder);
    if (!unfinished) return cannotMake(folder, unfinished.error());
    if (auto done = writeFiles(files, unfinished->path(), folder); !done) return done;
    if (auto done = unfinished->moveUp(); !done) return cannotMake(folder, done.error());
    return {};
}

/// A folder that appears under its name when it is complete.
Expected<void> writeNewFolder(const std::vector<CaseFile>& files, const fs::path& to) {
    std::error_code error;
    fs::path folder = fs::absolute(to, error);
    if (!folder.has_filename()) folder = folder.parent_path();  // "case/"
    fs::create_directories(folder.parent_path(), error);
    if (error) return cannotMake(to, systemReason(error));
    removeStale(folder.parent_path());
    auto unfinished = StagingFolder::make(folder.parent_path());
    if (!unfinished) return cannotMake(to, unfinished.error());
    if (auto done = writeFiles(files, unfinished->path(), to); !done) return done;
    if (auto done = unfinished->renameTo(folder); !done) return cannotMake(to, done.error());
    return {};
}

}  // namespace

Expected<void> checkCaseTarget(const fs::path& to) {
    std::error_code error;
    if (to.extension() == kCaseEnding || !fs::exists(to, error)) return {};
    if (fs::is_directory(to, error)) removeStale(to);
    if (fs::is_directory(to, error) && fs::is_empty(to, error)) return {};
    return unexpected(msg::kCaseTargetTaken, displayName(to), kCaseEnding);
}

Expected<void> writeCase(const std::vector<CaseFile>& files, const fs::path& to) {
    if (to.extension() == kCaseEnding) {
        const auto bytes = packCase(files);
        if (!bytes) return Unexpected{bytes.error()};
        return writeFile(to, *bytes);
    }
    if (auto done = checkCaseTarget(to); !done) return done;
    std::error_code error;
    return fs::exists(to, error) ? fillFolder(files, to) : writeNewFolder(files, to);
}

}  // namespace tactooth
