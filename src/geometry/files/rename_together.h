// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tactooth {

/// The rename of a complete file or folder.
struct PendingRename {
    std::string from;       ///< a temporary name, or the openFileName of a file without a name
    bool isOpen = false;    ///< `from` is an openFileName
    std::string to;         ///< an older file of that name is replaced; an older folder is not
    std::string spare;      ///< a random name in the folder of `to`
    bool replaces = false;  ///< there is an older file
    std::string backup;     ///< a second name of the older file; empty: it cannot have two
};

struct RenameFailure {
    int reason = 0;         ///< errno; 0: all have their names
    std::size_t which = 0;  ///< index of the rename that failed
};

/// Does all renames, or none. A child process does them that receives no signal to this process, so that a kill comes
/// before the first rename or after the last one. If no child can be started, this process does them. Afterwards no
/// file has the name `backup`.
[[nodiscard]] RenameFailure renameTogether(const std::vector<PendingRename>& renames);

}  // namespace tactooth
