// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/remark_lines.h"

#include "app/cli/output.h"

namespace tactooth {

void printRemarks(const std::vector<Remark>& remarks) {
    for (const Remark& remark : remarks) say(stderr, "tactooth: note: {}\n", inWords(remark));
}

}  // namespace tactooth
