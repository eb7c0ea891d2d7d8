// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <windows.h>

#include <filesystem>
#include <system_error>

#include "devices/base/shared_library.h"

namespace tactooth {

Expected<void*> loadSharedLibrary(const std::string& path) {
    const HMODULE library = LoadLibraryW(std::filesystem::path(path).c_str());
    if (library == nullptr)
        return unexpected(Message::verbatim(std::system_category().message(static_cast<int>(GetLastError()))));
    return static_cast<void*>(library);
}

void* findInLibrary(void* library, const char* name) {
    return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(library), name));
}

}  // namespace tactooth
