// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tactooth {

/// A complete file or folder that is to get its name.
struct PendingRename {
    std::string from;       ///< a temporary name, or openFileName of a file that has none
    bool isOpen = false;    ///< `from` is an openFileName
    std::string to;         ///< an older file of that name is replaced; an older folder is not
    std::string spare;      ///< a random name in the folder of `to`
    bool replaces = false;  ///< there is an older file
    std::string backup;     ///< a name that it has besides; empty: it cannot have two
};

struct RenameFailure {
    int reason = 0;         ///< errno; 0: all have their names
    std::size_t which = 0;  ///< of the namings
};

/// Gives all their names, or none. A child process does it that no signal to this one reaches, so that also a kill
/// comes before the first or after the last; where there can be none, this process does it itself. `backup` is taken
/// care of: afterwards no file has that name.
[[nodiscard]] RenameFailure renameTogether(const std::vector<PendingRename>& renames);

}  // namespace tactooth
