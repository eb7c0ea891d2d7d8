// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// The exit codes of the program.
enum ExitCode {
    kExitOk = 0,
    kExitNegative = 1,  ///< the command worked and its answer is no
    kExitBadInput = 2,  ///< wrong usage, or unusable input or output
};

/// Writes the import notes of the files to stderr, one line each.
void printImportNotes(const std::vector<ImportNote>& importNotes);

/// Writes the sentence to stderr as displayText formats it, with the program's name before it. Returns the exit code
/// for the error.
int reportError(const Error& error);

}  // namespace tactooth
