// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/exit_code.h"

#include <cstdio>

namespace tactooth {

void printRemarks(const std::vector<Remark>& remarks) {
    for (const Remark& remark : remarks) std::fprintf(stderr, "tactooth: %s\n", inWords(remark).c_str());
}

int refuse(const Error& error) {
    std::fprintf(stderr, "tactooth: %s\n", error.message.c_str());
    return kExitBadInput;
}

}  // namespace tactooth
