// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/remark_lines.h"

#include <cstdio>

namespace tactooth {

void printRemarks(const std::vector<Remark>& remarks) {
    for (const Remark& remark : remarks) std::fprintf(stderr, "tactooth: note: %s\n", inWords(remark).c_str());
}

}  // namespace tactooth
