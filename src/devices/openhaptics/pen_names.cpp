// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/openhaptics/pen_names.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace tactooth {
namespace {

namespace fs = std::filesystem;

/// Newer drivers keep their settings in the first of these folders; then files that an older driver has left in another
/// one are ignored.
std::vector<fs::path> defaultFolders() {
    std::vector<fs::path> homes = {"/usr/share/3DSystems", "/opt/geomagic_touch_device_driver"};
    const char* const user = std::getenv("HOME");
    if (user != nullptr && *user != 0) homes.insert(homes.begin(), fs::path(user) / ".3dsystems");
    return homes;
}

fs::path settingsFolder() {
    const char* const own = std::getenv("GTDD_HOME");
    if (own != nullptr && *own != 0) return fs::path(own) / "config";
    for (const fs::path& home : defaultFolders()) {
        std::error_code unknown;
        if (fs::is_directory(home / "config", unknown)) return home / "config";
    }
    return {};
}

bool isPen(const fs::directory_entry& entry) {
    std::error_code unknown;
    return entry.path().extension() == ".config" && entry.is_regular_file(unknown);
}

}  // namespace

std::vector<std::string> configuredPens() {
    std::vector<std::string> pens;
    std::error_code failure;
    for (fs::directory_iterator entry(settingsFolder(), failure), end; entry != end; entry.increment(failure)) {
        if (isPen(*entry)) pens.push_back(entry->path().stem().string());
    }
    std::ranges::sort(pens, {}, [](const std::string& pen) { return std::pair(pen != kDefaultPen, pen); });
    return pens;
}

}  // namespace tactooth
