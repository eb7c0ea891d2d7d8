// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// What libFuzzer looks for, for the one target that is linked beside it. A broken promise is not caught: that stops the
// process, and libFuzzer keeps the bytes.
#include <cstdint>

#include "fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (const auto& target : tactooth::test::fuzzTargets()) target.accepts(std::as_bytes(std::span(data, size)));
    return 0;
}
