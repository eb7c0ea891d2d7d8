// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <mutex>

namespace tactooth {

/// Held while files get or change their names, so that an end of the program from outside comes before or after it.
[[nodiscard]] std::unique_lock<std::timed_mutex> lockRenames();

/// What has a name before it is complete. Whoever gives such a name holds lockRenames() meanwhile.
enum class Unfinished {
    File,         ///< removed
    Folder,       ///< removed with all that is in it
    EmptyFolder,  ///< removed if nothing is in it
};
void registerUnfinished(const std::filesystem::path& path, Unfinished kind);
void unregisterUnfinished(const std::filesystem::path& path);

/// Removes all that is unfinished, newest first. For a program that ends at once: from then on no file gets a name, and
/// a thread that wants to give one waits for ever. `timeout` s are the longest wait for names that change just now.
void removeAllUnfinished(double timeout);

}  // namespace tactooth
