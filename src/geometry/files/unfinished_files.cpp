// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/unfinished_files.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace tactooth {
namespace {

struct Entry {
    std::filesystem::path path;
    Unfinished kind;
};

std::timed_mutex& nameMutex() {
    static auto* const mutex = new std::timed_mutex;  // lives longer than every thread that may still write
    return *mutex;
}

std::vector<Entry>& entries() {
    static auto* const all = new std::vector<Entry>;
    return *all;
}

}  // namespace

std::unique_lock<std::timed_mutex> lockRenames() { return std::unique_lock(nameMutex()); }

void registerUnfinished(const std::filesystem::path& path, Unfinished kind) {
    entries().push_back({std::filesystem::absolute(path), kind});
}

void unregisterUnfinished(const std::filesystem::path& path) {
    const std::filesystem::path whole = std::filesystem::absolute(path);
    std::erase_if(entries(), [&](const Entry& entry) { return entry.path == whole; });
}

void removeAllUnfinished(double timeout) {
    if (!nameMutex().try_lock_for(std::chrono::duration<double>(timeout))) return;
    std::error_code ignored;
    std::vector<Entry>& all = entries();
    for (auto entry = all.rbegin(); entry != all.rend(); ++entry) {
        if (entry->kind == Unfinished::File) ::unlink(entry->path.c_str());
        if (entry->kind == Unfinished::Folder) std::filesystem::remove_all(entry->path, ignored);
        if (entry->kind == Unfinished::EmptyFolder) ::rmdir(entry->path.c_str());
    }
}

}  // namespace tactooth
