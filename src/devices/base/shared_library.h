// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/util/expected.h"

namespace tactooth {

/// A vendor's library, brought in by the system's loader while the program runs. It stays until the program ends:
/// drivers keep threads of their own. `path`: a file, or a name that the loader finds. Fails with the loader's words.
[[nodiscard]] Expected<void*> loadSharedLibrary(const std::string& path);

/// What the library calls `name`; nullptr if it has no such thing.
[[nodiscard]] void* findInLibrary(void* library, const char* name);

}  // namespace tactooth
