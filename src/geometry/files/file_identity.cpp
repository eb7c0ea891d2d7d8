// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/file_identity.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxLinks = 40;  // the limit of the system

}  // namespace

fs::path linksFollowed(const fs::path& path) {
    fs::path place = path;
    std::error_code error;
    for (int i = 0; i < kMaxLinks && fs::is_symlink(fs::symlink_status(place, error)); ++i) {
        const fs::path link = fs::read_symlink(place, error);
        if (error) break;
        place = place.parent_path() / link;  // an absolute link replaces the whole path
    }
    return place;
}

FileIdentity FileIdentity::of(const fs::path& path) {
    FileIdentity place;
    std::error_code error;
    const fs::path whole = fs::absolute(linksFollowed(path), error);  // a missing path stays relative otherwise
    place.canonicalPath = fs::weakly_canonical(whole, error);
    if (error) place.canonicalPath = whole.lexically_normal();
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return place;
    place.device = status.st_dev;
    place.number = status.st_ino;
    return place;
}

bool FileIdentity::isInside(const FileIdentity& folder) const {
    const auto [end, rest] = std::mismatch(folder.canonicalPath.begin(), folder.canonicalPath.end(),
                                           canonicalPath.begin(), canonicalPath.end());
    return end == folder.canonicalPath.end() && rest != canonicalPath.end();
}

}  // namespace tactooth
