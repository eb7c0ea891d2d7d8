// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <mutex>

namespace tactooth {

/// Held while files are renamed, so that a signal that ends the program takes effect before or after it.
[[nodiscard]] std::unique_lock<std::timed_mutex> lockRenames();

/// What has a name before it is complete. The caller holds lockRenames() while it gives such a name.
enum class Unfinished {
    File,         ///< removed
    Folder,       ///< removed with its content
    EmptyFolder,  ///< removed if it is empty
};
void registerUnfinished(const std::filesystem::path& path, Unfinished kind);
void unregisterUnfinished(const std::filesystem::path& path);

/// Removes everything unfinished, newest first. For a program that ends at once: from then on no file gets a name, and
/// a thread that tries waits for ever. `timeout` s is the longest wait for renames in progress.
void removeAllUnfinished(double timeout);

}  // namespace tactooth
