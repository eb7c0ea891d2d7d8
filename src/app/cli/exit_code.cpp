// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/exit_code.h"

#include <cstdio>

namespace tactooth {

int refuse(const Error& error) {
    std::fprintf(stderr, "tactooth: %s\n", error.message.c_str());
    return kExitBadInput;
}

}  // namespace tactooth
