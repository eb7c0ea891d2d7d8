// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth::test {

/// Number of calls of operator new in this program, in any form and on any thread. Only for programs that link
/// tactooth_test_heap_counter, which replaces operator new.
[[nodiscard]] long heapCalls();

}  // namespace tactooth::test
