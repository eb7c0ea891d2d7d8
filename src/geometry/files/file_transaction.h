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

/// The output files of one command: all of them appear, or none. They are opened before the work, so that an obstacle
/// is reported at once. While the transaction lives, an AtomicFile with one of these paths uses the opened file, and
/// its commit waits for that of the transaction. There is one transaction at a time.
class FileTransaction {
public:
    FileTransaction();
    ~FileTransaction();
    FileTransaction(const FileTransaction&) = delete;
    FileTransaction& operator=(const FileTransaction&) = delete;

    /// Registers a file that is read, or a folder that is read from: nothing may be written in its place. Empty: none.
    void reads(const std::filesystem::path& path);
    /// Makes a folder and its missing parents. Without a commit they are removed again, if they are empty.
    [[nodiscard]] Expected<void> makeFolder(const std::filesystem::path& folder);
    /// Fails with one sentence if `path` is read, or is in the transaction already under any name.
    [[nodiscard]] Expected<void> checkFree(const std::filesystem::path& path) const;
    /// Opens a file; one that is not written stays unchanged. Empty: none. Fails with one sentence if it is not free
    /// (see checkFree), or for a reason of AtomicFile.
    [[nodiscard]] Expected<void> open(const std::filesystem::path& path);

    /// Gives all written files their names, or none.
    [[nodiscard]] Expected<void> commit();

    /// The present transaction, or null.
    [[nodiscard]] static FileTransaction* current();
    /// For AtomicFile: the opened file of a path, once; null if there is none.
    [[nodiscard]] std::unique_ptr<PendingFile> handOut(const std::filesystem::path& path);
    void takeFinished(std::unique_ptr<PendingFile> file);

private:
    /// A file, and the path that named it.
    struct Known {
        FileIdentity place;
        std::filesystem::path name;
    };
    void removeFolders();

    std::vector<Known> read_;
    std::vector<Known> written_;
    std::vector<std::filesystem::path> folders_;  // that were made, outer folders first
    std::mutex mutex_;                            // several threads may create files
    std::vector<std::unique_ptr<PendingFile>> opened_;
    std::vector<std::unique_ptr<PendingFile>> finished_;
};

}  // namespace tactooth
