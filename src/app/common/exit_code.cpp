// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/exit_code.h"

#include <cstdio>
#include <string>

#include "geometry/util/display_text.h"

namespace tactooth {

void printImportNotes(const std::vector<ImportNote>& importNotes) {
    for (const ImportNote& importNote : importNotes)
        std::fprintf(stderr, "tactooth: %s\n", displayText(inWords(importNote)).c_str());
}

int reportError(const Error& error) {
    std::string sentence = displayText(error.message());
    if (!sentence.ends_with('.')) sentence += '.';  // the text of a library may have no full stop
    std::fprintf(stderr, "tactooth: %s\n", sentence.c_str());
    return kExitBadInput;
}

}  // namespace tactooth
