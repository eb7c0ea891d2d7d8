// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A library is tried before it is trusted. The one part of this folder that needs a POSIX system.
#include <mutex>
#include <set>

#include "devices/base/messages.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/probe/child_probe.h"

namespace tactooth {
namespace {

constexpr double kConnectTimeout = 10;  // s: a driver that looks for its device takes a few

/// Nothing, or why the library cannot be used.
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
    const auto tried = inChildProcess([&path] { return startAndEnd(path); }, kConnectTimeout);
    if (!tried) {
        return unexpected(msg::kLibraryBroken, path, tried.error());
    }
    if (tried->empty()) harmless.insert(path);
    return {};
}

}  // namespace tactooth
