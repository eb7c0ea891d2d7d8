// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/exit_code.h"

#include <cstdio>
#include <string>

#include "geometry/util/shown_text.h"

namespace tactooth {

void printRemarks(const std::vector<Remark>& remarks) {
    for (const Remark& remark : remarks) std::fprintf(stderr, "tactooth: %s\n", shownText(inWords(remark)).c_str());
}

int refuse(const Error& error) {
    std::string sentence = shownText(error.message);
    if (!sentence.ends_with('.')) sentence += '.';  // a library's own words may have none
    std::fprintf(stderr, "tactooth: %s\n", sentence.c_str());
    return kExitBadInput;
}

}  // namespace tactooth
