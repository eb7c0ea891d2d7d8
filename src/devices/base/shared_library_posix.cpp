// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>

#include "devices/base/shared_library.h"

namespace tactooth {

Expected<void*> loadSharedLibrary(const std::string& path) {
    void* const library = dlopen(path.c_str(), RTLD_LAZY | RTLD_GLOBAL);
    if (library == nullptr) return unexpected(Message::verbatim(dlerror()));
    return library;
}

void* findInLibrary(void* library, const char* name) { return dlsym(library, name); }

}  // namespace tactooth
