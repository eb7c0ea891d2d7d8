// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/util/expected.h"

namespace tactooth {

/// Loads a vendor's library at run time with the system's loader. It stays loaded until the program ends, because
/// drivers keep threads of their own. `path`: a file, or a name that the loader finds. Fails with the loader's error
/// text.
[[nodiscard]] Expected<void*> loadSharedLibrary(const std::string& path);

/// Address of the symbol `name` in the library; nullptr if the library does not have it.
[[nodiscard]] void* findInLibrary(void* library, const char* name);

}  // namespace tactooth
