// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// The commit that the sources were at when they were built, or "unknown".
extern const char* const kCommit;

}  // namespace tactooth
