// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Every test of this program runs as on a machine without a sound card: OpenAL gets no driver before its first call.
// Its loopback device needs none.
#include <cstdlib>

namespace {
[[maybe_unused]] const int noDriver = setenv("ALSOFT_DRIVERS", "none", 1);
}  // namespace
