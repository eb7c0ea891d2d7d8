// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/files/file_identity.h"
#include "geometry/util/expected.h"

namespace tactooth {

class PendingFile;

/// The files that one piece of work leaves behind: all of them, or none. They are opened before the work, so that what
/// stands in the way of them is said at once; while the set lives, an AtomicFile of one of these paths is the file that
/// was opened, and its commit waits for that of the set. One set at a time.
class FileTransaction {
public:
    FileTransaction();
    ~FileTransaction();
    FileTransaction(const FileTransaction&) = delete;
    FileTransaction& operator=(const FileTransaction&) = delete;

    /// A file that is read, or a folder that is read from: nothing may be written in its place. Empty: none.
    void reads(const std::filesystem::path& path);
    /// Makes a folder and those above it where they are not there. Without a commit they go again, if they are empty.
    [[nodiscard]] Expected<void> makeFolder(const std::filesystem::path& folder);
    /// Fails with one sentence if `path` is read, or in the set already under whatever name.
    [[nodiscard]] Expected<void> checkFree(const std::filesystem::path& path) const;
    /// Opens a file; one that is not written in the end is left as it was. Empty: none. Fails with one sentence if it
    /// is not free (see checkFree), or for a reason of AtomicFile.
    [[nodiscard]] Expected<void> open(const std::filesystem::path& path);

    /// Gives all files that were written their names, or none.
    [[nodiscard]] Expected<void> commit();

    /// The living set, or null.
    [[nodiscard]] static FileTransaction* current();
    /// For AtomicFile: the opened file behind a path, once; null if there is none.
    [[nodiscard]] std::unique_ptr<PendingFile> handOut(const std::filesystem::path& path);
    void takeFinished(std::unique_ptr<PendingFile> file);

private:
    /// A file, and how it was called.
    struct Known {
        FileIdentity place;
        std::filesystem::path name;
    };
    void removeFolders();

    std::vector<Known> read_;
    std::vector<Known> written_;
    std::vector<std::filesystem::path> folders_;  // that were made, the outer ones first
    std::mutex mutex_;                            // several threads may create files
    std::vector<std::unique_ptr<PendingFile>> opened_;
    std::vector<std::unique_ptr<PendingFile>> finished_;
};

}  // namespace tactooth
