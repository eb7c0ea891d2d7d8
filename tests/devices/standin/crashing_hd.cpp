// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A library that crashes its program while it is being loaded.
#include <csignal>

namespace {
[[maybe_unused]] const int crashed = std::raise(SIGSEGV);
}
