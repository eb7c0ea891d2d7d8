// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Tries a library in a child process before this process uses it. The only part of this folder that needs a POSIX
// system.
#include <mutex>
#include <set>

#include "devices/base/messages.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/probe/child_probe.h"

namespace tactooth {
namespace {

constexpr double kProbeTimeout = 10;  // s: a driver needs a few seconds to look for its device

/// Empty, or the reason why the library cannot be used.
std::string startAndEnd(const std::string& path) {
    const auto library = HdLibrary::load(path);
    if (!library) return library.error().message();
    const HdFunctions& call = (*library)->call();
    const HdHandle handle = call.initDevice(nullptr);
    if (call.getError().code == 0 && handle <= hd::kLargestHandle) call.disableDevice(handle);
    return {};
}

}  // namespace

Expected<void> HdLibrary::probeLibrary(const std::string& path) {
    static std::mutex mutex;
    static std::set<std::string> harmless;
    const std::lock_guard lock(mutex);
    if (harmless.contains(path)) return {};
    const auto tried = inChildProcess([&path] { return startAndEnd(path); }, kProbeTimeout);
    if (!tried) {
        return unexpected(msg::kLibraryBroken, path, tried.error());
    }
    if (tried->empty()) harmless.insert(path);
    return {};
}

}  // namespace tactooth
