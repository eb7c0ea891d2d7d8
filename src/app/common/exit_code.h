// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// What the program tells the shell.
enum ExitCode {
    kExitOk = 0,
    kExitNegative = 1,  ///< the command worked and its answer is no
    kExitBadInput = 2,  ///< wrong usage, or an input or output that cannot be used
};

/// Writes what there is to say on the files that were read to stderr, a line each.
void printImportNotes(const std::vector<ImportNote>& importNotes);

/// Writes the sentence to stderr as displayText shows it, with the program's name before it, and gives the exit code
/// that goes with it.
int reportError(const Error& error);

}  // namespace tactooth
